// The manual, from wherever one is.
#pragma once

#include "app/window/workplace.h"

#include <QObject>
#include <QString>

class QWidget;

namespace suffuse {

/// Opens the manual. Its key turns to the page about what has the keyboard: a panel, a dialog, or on the canvas the tool
/// in use. Its entry in the menu turns to no page.
class Helping : public QObject {
    Q_OBJECT

public:
    Helping(const Workplace &place, QObject *parent);

    /// The name of the page about a widget of this window, or of its dialogs.
    QString pageAbout(const QWidget *widget) const;

    bool eventFilter(QObject *watched, QEvent *event) override;

private:
    bool isAskedIn(const QObject &watched, const QEvent &event) const;

    const Workplace m_place;
};

} // namespace suffuse
