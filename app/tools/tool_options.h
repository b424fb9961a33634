#pragma once

#include <QToolBar>

class QStackedWidget;

namespace suffuse {

/// The row over the canvas, which shows what can be set for the tool in use. It is as high as the highest row of all
/// tools, so that the canvas stays where it is when the tool changes.
class ToolOptionsBar : public QToolBar {
    Q_OBJECT

public:
    explicit ToolOptionsBar(const QString &title, QWidget *parent = nullptr);

    /// Shows a widget, which belongs to the row from then on; null shows nothing.
    void setWidget(QWidget *widget);

private:
    QStackedWidget *m_stack;
};

} // namespace suffuse
