#pragma once

#include "app/session/selecting/snapping.h"
#include "app/tools/assistants/assistant_row.h"
#include "app/tools/canvas_tool.h"

#include <QPointer>

namespace suffuse {

/// Makes assistants and changes them: a drag where there is none makes one of the kind in the row, a drag of a point or
/// of a line changes the one that it belongs to. Without a pointer, Tab goes from point to point, arrow keys move what
/// is chosen, Return makes a new one, and Delete removes.
class AssistantTool : public CanvasTool {
    Q_OBJECT

public:
    AssistantTool(CanvasWidget &canvas, Commands &commands, QObject *parent = nullptr);

    QString hint() const override;
    QCursor cursor() const override;
    QWidget *options() override;
    void press(const PointerEvent &event) override;
    void move(const PointerEvent &event) override;
    void release(const PointerEvent &event) override;
    void hover(const PointerEvent &event) override;
    bool showsOutlines() const override { return false; }
    bool isBusy() const override { return m_busy; }
    void cancel() override;
    bool keyPress(QKeyEvent *event) override;
    bool wantsKey(const QKeyEvent &event) const override;
    bool hasChosen() const override { return chosen() != nullptr; }
    bool deleteSelected() override;
    void paint(QPainter &painter, const View &view, double dpr) const override;

    AssistantKind kind() const { return m_kind; }
    /// Of the next one; it is remembered in the settings.
    void setKind(AssistantKind kind);

private:
    /// An assistant by its number, or a point of it.
    struct Part {
        int assistant = -1; ///< −1: none
        int point = -1;     ///< −1: all of it
        friend bool operator==(const Part &, const Part &) = default;
    };

    const Assistant *chosen() const;
    Part partAt(Point pixel) const;
    void choose(const Part &part);
    void chooseNext(int step);
    void addInMiddle();
    void add(Assistant assistant);
    void replace(const Assistant &assistant);
    Assistant made(const PointerEvent &event) const;
    Assistant dragged(const PointerEvent &event) const;
    Point snapped(Point point) const;
    void enter(AssistantRow::Number number, double value);
    /// After the assistants have changed.
    void follow();
    void showNumbers();

    Commands &m_commands;
    AssistantKind m_kind;
    QPointer<AssistantRow> m_row; ///< belongs to the row over the canvas
    Part m_chosen;
    Part m_over; ///< under the pointer
    bool m_busy = false;
    bool m_moved = false;            ///< far enough to be a drag
    bool m_makes = false;            ///< the drag makes a new one
    std::vector<Assistant> m_before; ///< when it was pressed
    Part m_chosenBefore;
    Point m_pixel; ///< of the press
    Point m_from;  ///< of the press, canvas units; of a new one, what it was snapped to
    Snapping m_snapping;
};

} // namespace suffuse
