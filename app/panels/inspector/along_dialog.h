#pragma once

#include "app/panels/inspector/stroke_run.h"
#include "app/session/gesture.h"
#include "app/widgets/curves/curve_editor.h"

#include <QDialog>

#include <map>

class QButtonGroup;
class QComboBox;
class QLabel;

namespace suffuse {

class Editor;
class HintLabel;
class NumberField;

/// The dialog "Along the Stroke". It sets quantities over the arc length of runs of segments: those that are selected
/// when it opens. All that is done in it shows at once and is one undo step; Cancel takes it back. When something else
/// changes the strokes that it is about, it closes by itself and keeps what was done.
class AlongDialog : public QDialog {
    Q_OBJECT

public:
    enum Shape { Constant, Ramp, Drawn };

    AlongDialog(Editor &editor, QWidget *parent);
    ~AlongDialog() override;

    /// Shows another quantity.
    void choose(Quantity quantity);
    /// Gives the curve another shape.
    void choose(Shape shape);
    CurveEditor *curve() const { return m_curve; }
    NumberField *start() const { return m_start; }
    NumberField *end() const { return m_end; }

    void accept() override;
    void reject() override;

protected:
    void keyPressEvent(QKeyEvent *event) override;

private:
    /// The axis of a quantity, which maps values to [0, 1] and back.
    struct Axis {
        double low = 0, high = 1;
        bool logarithmic = false;
        bool reversed = false; ///< whether the displayed number falls as the value grows
        double toShare(double value) const;
        double toValue(double place) const;
    };

    void addChoice();
    void addFields();
    void showQuantity();
    void showFields();
    Axis axisOf(Quantity quantity) const;
    std::vector<QPointF> presentOf(Quantity quantity) const;
    void setEnd(std::size_t knot, double value);
    void apply();
    void showValues();
    void giveUpDrag();
    const StrokeRuns &runsToSet();
    void documentChanged(const Change &change);

    Editor &m_editor;
    StrokeRuns m_runs;
    std::optional<StrokeRuns> m_refined; ///< the runs with shorter segments, made once something varies
    Gesture m_gesture;                   ///< open from the first change until the dialog closes
    Quantity m_quantity = Quantity::Density;
    Axis m_axis;
    /// A curve that was set in this dialog, and the axis that it belongs to.
    struct Set {
        PlaceCurve curve;
        Axis axis;
    };
    std::map<Quantity, Set> m_set;
    std::optional<std::map<Quantity, Set>> m_beforeDrag; ///< what was set when the drag of the curve began
    bool m_applying = false;
    bool m_finished = false; ///< whether a change from elsewhere has ended the dialog

    QComboBox *m_choice = nullptr;
    QButtonGroup *m_shapes = nullptr;
    CurveEditor *m_curve = nullptr;
    QLabel *m_endLabel = nullptr;
    NumberField *m_start = nullptr;
    NumberField *m_end = nullptr;
    HintLabel *m_hint = nullptr;
};

} // namespace suffuse
