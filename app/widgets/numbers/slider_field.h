#pragma once

#include "app/session/value_entry.h"
#include "app/widgets/numbers/number_field.h"
#include "model/restyling/value_change.h"

#include <QLabel>
#include <QWidget>

#include <functional>
#include <optional>
#include <vector>

class QGridLayout;

namespace suffuse {

class BarSlider;

/// How a quantity looks in a panel.
struct FieldSpec {
    QString name;    ///< label, translated
    QString toolTip; ///< translated
    Display display = {};
    double minimum = 0; ///< smallest value of the domain
    double maximum = 1;
    double sliderMinimum = 0; ///< smallest value of the slider, within the domain
    double sliderMaximum = 1;
    bool logarithmic = false;
    double step = 0;         ///< step of the arrow keys; 0: a tenth of the value
    double sliderStep = 0;   ///< the slider's values are whole multiples of it; 0: any values
    double defaultValue = 0; ///< a double click resets to it
};

/// A label, a slider and a number field for one quantity, laid out in three columns of a grid that the panel owns.
/// Emits changes with the entry by which they come in: a whole drag is one gesture, quick repeated key or wheel steps
/// are one step.
///
/// Where the values are mixed, the slider changes each of them: by a factor where it is logarithmic, else by a
/// difference. Its handle begins in the middle, and the number says the change ("×1.20", "+10 %") until the panel has
/// it forgotten. With Ctrl the slider makes one value of all.
class SliderField : public QObject {
    Q_OBJECT

public:
    /// Adds its widgets as a row of the grid.
    SliderField(const FieldSpec &spec, QGridLayout &grid, int row, QWidget *parent);

    void setValue(std::optional<double> value); ///< nullopt: mixed; emits nothing
    /// The value is one of several that differ: the number says "—". Unlike where they are mixed, the slider stands at
    /// the value and makes it that of all.
    void setOneOfSeveral(bool several);
    /// The change of mixed values that is shown, if any. It counts from the painting `entry().start()`.
    std::optional<ValueChange> change() const;
    /// The values are what they are now; the handle goes back to the middle.
    void forgetChange();
    /// Keeps showing the change while `holds` says that the values are what it makes of those in `entry().start()`.
    /// After an undo or a redo it shows that of the changes since then which holds, which may be none at all (×1.00).
    /// Where no change holds, it is forgotten.
    void keepChange(const std::function<bool(const ValueChange &)> &holds);
    ValueEntry &entry() { return m_entry; }
    void setEnabled(bool enabled);
    void setVisible(bool visible);
    /// Sets another domain (those of ξ depend on each other). The slider's part of it is cut to fit.
    void setRange(double minimum, double maximum);
    void setSliderRange(double minimum, double maximum);
    double minimum() const { return m_spec.minimum; }
    double maximum() const { return m_spec.maximum; }
    void setDefaultValue(double value) { m_spec.defaultValue = value; }
    void rename(const QString &name, const QString &toolTip);

    QLabel *label() const { return m_label; }
    BarSlider *slider() const { return m_slider; }
    NumberField *number() const { return m_number; }

signals:
    /// To be pushed with the entry; null: a step of its own.
    void edited(double value, suffuse::ValueEntry *entry);
    /// Each of the mixed values is to change by the map, which keeps to the field's range: nothing beyond it.
    void editedRelative(const suffuse::ValueMap &map);
    /// Each of the mixed values is to be what the change makes of the one that it had in `entry->start(document)`.
    void changed(const suffuse::ValueChange &change, suffuse::ValueEntry *entry);
    void dragStarted();
    void dragEnded();
    void refused(const QString &hint);

protected:
    bool eventFilter(QObject *watched, QEvent *event) override;

private:
    void sliderPressed();
    void sliderChanged(int position);
    void changeAll(double amount, ValueEntry *entry);
    void noteAmount();
    void stepAll(double steps);
    void stepToOne(double steps);
    void giveUp();
    ValueEntry *step();
    int toPosition(double value) const;
    double toValue(int position) const;
    /// The same for the change of mixed values.
    ValueChange::Kind changeKind() const;
    int positionOf(double amount) const;
    double amountAt(int position) const;
    QString changeText() const;
    void showMixed(bool mixed);

    FieldSpec m_spec;
    QString m_toolTip;
    QLabel *m_label;
    BarSlider *m_slider;
    NumberField *m_number;
    std::optional<double> m_value;
    bool m_isOneOfSeveral = false;
    std::optional<double> m_amount;       ///< of the change of mixed values that is shown
    std::vector<double> m_amounts;        ///< those of steps since the change began to be counted
    std::optional<double> m_pressedValue; ///< returned to exactly where the handle returns to m_pressedPosition
    std::optional<double> m_pressedAmount;
    int m_pressedPosition = 0;
    ValueEntry m_entry;
};

} // namespace suffuse
