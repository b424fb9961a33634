// Windows that stay open beside the picture.
#pragma once

#include "app/window/workplace.h"

#include <QObject>

namespace suffuse {

/// Gives each window that stays open beside the main window, such as Along the Stroke, the commands that people use
/// wherever they are: they undo, redo, save and quit there, too. A window that asks something first (a modal dialog)
/// has none.
class SideWindows : public QObject {
    Q_OBJECT

public:
    SideWindows(const Workplace &place, QObject *parent);

    bool eventFilter(QObject *watched, QEvent *event) override;

private:
    const Workplace m_place;
};

} // namespace suffuse
