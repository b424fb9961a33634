#pragma once

#include "model/painting/painting.h"

#include <QWidget>

class QMenu;

namespace suffuse {

/// Shows colours to pick from. It has one line, with as many as fit; where it may be edited, it has rows. Then colours
/// can be dropped, moved by dragging, named, linked and removed. It changes nothing itself, but emits which swatches
/// there should be. A linked swatch has a white corner.
/// Arrow keys choose a swatch, Return picks it, Delete removes it, F2 names it, the menu key shows what else there is.
class SwatchGrid : public QWidget {
    Q_OBJECT

public:
    SwatchGrid(bool editable, QWidget *parent);

    void setSwatches(std::vector<Swatch> swatches);
    const std::vector<Swatch> &swatches() const { return m_swatches; }
    /// Shows all swatches in rows, though they may not be edited.
    void showAll();
    /// Sets the text that is shown where there is no swatch.
    void setEmptyText(const QString &text);

    void insert(int index, const Colour &colour);
    void move(int from, int to); ///< `to` is the swatch before which it goes, counted before the move
    void rename(int index, const QString &name);
    void remove(int index);
    void setLinked(int index, bool linked);
    /// Frames a swatch while its colour is being changed; −1: none.
    void setEdited(int index);
    /// What can be done with a swatch that may be edited. The caller owns the menu.
    QMenu *menuFor(int index);

    /// Where a swatch stands. The index after the last one is the place where the next one would stand.
    QRect cell(int index) const;

    bool hasHeightForWidth() const override { return true; }
    int heightForWidth(int width) const override;
    QSize sizeHint() const override;
    QSize minimumSizeHint() const override;

signals:
    /// Emitted when a colour is picked.
    void picked(const suffuse::Colour &colour);
    /// Emitted when there should be other swatches; `undoText` names the step.
    void edited(const std::vector<suffuse::Swatch> &swatches, const QString &undoText);
    void changeWanted(int index); ///< the colour of the swatch is to be changed
    void usersWanted(int index);  ///< what is painted in the colour of the swatch is to be selected

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
    int shown(int width) const;   ///< how many there is room for in a width
    int indexAt(QPoint at) const; ///< the swatch at a place; −1: none
    int gapAt(QPoint at) const;   ///< the swatch before which something would go that is dropped at a place
    void setCurrent(int index);
    void setGap(int gap);
    void askName(int index);
    void startDrag(int index);
    int size() const { return int(m_swatches.size()); }

    std::vector<Swatch> m_swatches;
    QString m_emptyText;
    bool m_editable;
    bool m_rows; ///< as many as there are swatches, else one
    int m_current = 0;
    int m_edited = -1;
    int m_pressed = -1;
    QPoint m_pressedAt;
    int m_gap = -1; ///< the swatch before which a drop would go; −1: no drag
};

} // namespace suffuse
