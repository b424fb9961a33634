#pragma once

#include <QScrollArea>

namespace suffuse {

/// Scrolls a row of fields and buttons sideways where there is less room than it needs, so that no row makes the window
/// wider. It is as high as the row, and by a scroll bar higher where there is one.
class RowScroll : public QScrollArea {
public:
    explicit RowScroll(QWidget *row);

    QSize sizeHint() const override;
    QSize minimumSizeHint() const override;

protected:
    void resizeEvent(QResizeEvent *event) override;
    void wheelEvent(QWheelEvent *event) override;

private:
    int height(const QWidget &row) const;
};

} // namespace suffuse
