#pragma once

#include "app/session/settings/pen_input.h"
#include "model/brush/brush.h"

#include <QWidget>

class QCheckBox;
class QComboBox;

namespace suffuse {

class PenPad;
class ResponseEditor;

/// The page of the settings for the pen: its pressure curve, a sheet to try it on, and whether fingers paint.
class PenPage : public QWidget {
    Q_OBJECT

public:
    PenPage(const PenSettings &settings, const Brush &brush, QWidget *parent);

    PenSettings settings() const;
    QComboBox *feel() const { return m_feel; }
    ResponseEditor *curve() const { return m_curve; }
    PenPad *pad() const { return m_pad; }
    QCheckBox *fingersMoveView() const { return m_fingers; }

private:
    void showFeel();

    QComboBox *m_feel = nullptr;
    ResponseEditor *m_curve = nullptr;
    PenPad *m_pad = nullptr;
    QCheckBox *m_fingers = nullptr;
};

} // namespace suffuse
