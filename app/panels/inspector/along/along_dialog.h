#pragma once

#include "app/panels/inspector/along/along_states.h"
#include "app/session/gesture.h"

#include <QDialog>

#include <map>
#include <utility>
#include <vector>

class QButtonGroup;
class QComboBox;
class QHBoxLayout;
class QLabel;

namespace suffuse {

class Editor;
class HintLabel;
class NumberField;

/// The dialog "Along the Stroke". It sets quantities over the arc length of the runs of segments that are selected, and
/// names their stroke in its title. All that is done in it shows at once and is one undo step; Cancel takes it back.
/// Undo and redo go through the changes of one curve first; where the painting is saved, or undo goes on to what was
/// done before, each of them becomes a step, and Cancel takes them back by one more. Where something else is selected
/// it goes on with that, and OK and Cancel decide what was done before, too. Where something else changes the strokes
/// that it is about, it goes on from there; where one of them goes, it closes by itself and keeps what was done.
class AlongDialog : public QDialog, private GestureSteps {
    Q_OBJECT

public:
    enum Shape { Constant, Ramp, Points, Drawn };

    AlongDialog(Editor &editor, QWidget *parent);
    ~AlongDialog() override;

    /// Shows another quantity.
    void choose(Quantity quantity);
    /// Gives the curve another shape.
    void choose(Shape shape);
    CurveEditor *curve() const { return m_curve; }
    NumberField *start() const { return m_start; }
    NumberField *end() const { return m_end; }
    /// Multiplies all values of the quantity, or adds to them, when a number is entered; what varies stays.
    NumberField *scale() const { return m_scale; }

    void accept() override;
    void reject() override;

private:
    /// What was set before or after each change, with the quantity that was shown. The last is the next to step to.
    using Changes = std::vector<std::pair<Quantity, CurvesSet>>;
    struct BeforeDrag {
        CurvesSet set;
        Changes future;
    };

    bool canStep(bool back) const override { return !(back ? m_past : m_future).empty(); }
    void step(bool back) override;
    void handOver(const std::function<bool()> &commit, const std::function<void()> &undo) override;
    void goOnFromStep();
    void addChoice();
    void addFields();
    void showQuantity();
    void showFields();
    ValueAxis axisOf(Quantity quantity) const;
    std::vector<QPointF> presentOf(Quantity quantity) const;
    void addScale(QHBoxLayout &row);
    void showScale();
    /// The curve that is shown.
    CurveAlong shown() const { return {m_curve->curve(), m_axis, m_from}; }
    void set(const CurveAlong &curve);
    void scaleBy(double amount);
    void setEnd(std::size_t knot, double value);
    void note();
    void apply();
    void showValues();
    void showRuns(const StrokeRuns &runs, const std::map<Quantity, ValueAlong> &values);
    void giveUpDrag();
    void documentChanged(const Change &change);
    void follow();
    void showSubject();

    Editor &m_editor;
    AlongState m_state;
    AlongStates m_states; ///< that were shown so far
    Gesture m_gesture;    ///< open from the first change until the dialog closes
    Quantity m_quantity = Quantity::Density;
    ValueAxis m_axis;
    std::optional<PlaceCurve> m_from;       ///< belongs to the curve that is shown, as in CurveAlong
    std::optional<BeforeDrag> m_beforeDrag; ///< when the drag of the curve began, or was saved last
    Changes m_past, m_future;
    bool m_applying = false;
    bool m_finished = false; ///< whether a change from elsewhere has ended the dialog

    QWidget *m_body = nullptr; ///< all but the hint and the buttons
    QComboBox *m_choice = nullptr;
    QButtonGroup *m_shapes = nullptr;
    CurveEditor *m_curve = nullptr;
    QLabel *m_endLabel = nullptr;
    NumberField *m_start = nullptr;
    NumberField *m_end = nullptr;
    QLabel *m_scaleLabel = nullptr;
    NumberField *m_scale = nullptr;
    HintLabel *m_hint = nullptr;
};

} // namespace suffuse
