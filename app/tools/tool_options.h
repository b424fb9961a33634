#pragma once

#include <QToolBar>

class QStackedWidget;

namespace suffuse {

/// The row over the canvas: shows what the tool in use has to set. It is as high as the highest of them, so that the
/// canvas stays where it is when the tool changes.
class ToolOptionsBar : public QToolBar {
    Q_OBJECT

public:
    explicit ToolOptionsBar(const QString &title, QWidget *parent = nullptr);

    /// Shows a widget, which belongs to the row from then on; null: nothing.
    void setWidget(QWidget *widget);

private:
    QStackedWidget *m_stack;
};

} // namespace suffuse
