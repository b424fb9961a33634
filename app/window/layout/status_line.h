// What the status bar says.
#pragma once

#include "app/window/workplace.h"

#include <QObject>

class QLabel;

namespace suffuse {

struct FrameInfo;

/// Shows the hint of the tool in use, where the pointer is, the zoom, what draws the picture and how fast, and what
/// commands have to say.
class StatusLine : public QObject {
    Q_OBJECT

public:
    StatusLine(const Workplace &place, QObject *parent);

    /// Shows who has the keyboard, in place of the tool's hint, which is about the canvas; an empty sentence brings the
    /// hint back.
    void sayWhoHasKeyboard(const QString &sentence);

private:
    void makeLabels();
    void showHint();
    void showPosition(double x, double y);
    void showZoom();
    void showFrame(const FrameInfo &frame);
    void showBackend();

    Workplace m_place;
    QLabel *m_hint = nullptr;
    QLabel *m_position = nullptr;
    QLabel *m_zoom = nullptr;
    QLabel *m_backend = nullptr;
    QLabel *m_frameTime = nullptr;
    QString m_backendText; ///< of the last frame
    QString m_renderError;
    QString m_keyboard; ///< the sentence that says which panel has the keyboard
};

} // namespace suffuse
