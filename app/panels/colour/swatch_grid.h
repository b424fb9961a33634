#pragma once

#include "model/painting/painting.h"

#include <QWidget>

namespace suffuse {

/// Colours to pick from: one line of them, as many as fit; or, where it may be edited, rows. Then colours can be
/// dropped, moved by dragging, named and removed; it changes nothing itself but says what there should be. Keys:
/// arrows, Return picks, Delete removes, F2 names.
class SwatchGrid : public QWidget {
    Q_OBJECT

public:
    SwatchGrid(bool editable, QWidget *parent);

    void setSwatches(std::vector<Swatch> swatches);
    const std::vector<Swatch> &swatches() const { return m_swatches; }
    /// What an empty one says.
    void setEmptyText(const QString &text);

    void insert(int index, const Colour &colour);
    void move(int from, int to); ///< `to`: before which one, counted before the move
    void rename(int index, const QString &name);
    void remove(int index);

    /// Where a swatch is; of the one after the last: where it would be.
    QRect cell(int index) const;

    bool hasHeightForWidth() const override { return true; }
    int heightForWidth(int width) const override;
    QSize sizeHint() const override;
    QSize minimumSizeHint() const override;

signals:
    void picked(const suffuse::Colour &colour);
    void edited(const std::vector<suffuse::Swatch> &swatches, const QString &undoText);

protected:
    bool event(QEvent *event) override;
    void paintEvent(QPaintEvent *event) override;
    void mousePressEvent(QMouseEvent *event) override;
    void mouseMoveEvent(QMouseEvent *event) override;
    void mouseReleaseEvent(QMouseEvent *event) override;
    void contextMenuEvent(QContextMenuEvent *event) override;
    void keyPressEvent(QKeyEvent *event) override;
    void dragEnterEvent(QDragEnterEvent *event) override;
    void dragMoveEvent(QDragMoveEvent *event) override;
    void dragLeaveEvent(QDragLeaveEvent *event) override;
    void dropEvent(QDropEvent *event) override;

private:
    int columns(int width) const;
    int shown(int width) const;   ///< how many there is room for
    int indexAt(QPoint at) const; ///< −1: none
    int gapAt(QPoint at) const;   ///< before which one something dropped would come
    void setCurrent(int index);
    void setGap(int gap);
    void askName(int index);
    void startDrag(int index);
    int size() const { return int(m_swatches.size()); }

    std::vector<Swatch> m_swatches;
    QString m_emptyText;
    bool m_editable;
    int m_current = 0;
    int m_pressed = -1;
    QPoint m_pressedAt;
    int m_gap = -1; ///< where a drop would come
};

} // namespace suffuse
