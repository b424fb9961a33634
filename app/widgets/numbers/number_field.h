#pragma once

#include "app/widgets/habits/entry_field.h"
#include "app/widgets/numbers/display.h"

#include <functional>
#include <optional>

namespace suffuse {

/// Maps a value to the one that takes its place.
using ValueMap = std::function<std::optional<double>(double)>;

/// A field for one number with a unit. It takes arithmetic ("12*1.5", "+2") and steps by arrow keys and the wheel.
/// Where several values are mixed it shows "—", and "*1.2" or "+2" then changes each of them. A number outside the
/// range is refused, never clamped in silence.
class NumberField : public EntryField {
    Q_OBJECT

public:
    explicit NumberField(QWidget *parent = nullptr);

    /// Sets the range, which is closed. An end that is open in the domain is given as the smallest value allowed.
    void setRange(double minimum, double maximum);
    double minimum() const { return m_minimum; }
    double maximum() const { return m_maximum; }
    /// Sets the unit that is shown behind the number, " s" or " %". It is taken off again where it is typed.
    void setUnit(const QString &unit);
    /// Sets unit, factor, sense and decimals of the number that is shown and typed.
    void setDisplay(const Display &display);
    /// The same as it is here and now: a length is shown as in all of the window.
    Display display() const;
    /// A length is to be shown as the window shows lengths from now on.
    void followUnits();
    /// Sets the step of the arrow keys; 0: a tenth of the value.
    void setStep(double step) { m_step = step; }
    /// Allows whole numbers only.
    void setInteger(bool integer)
    {
        m_integer = integer;
        m_display.decimals = integer ? 0 : -1;
    }

    /// Shows a value, or "—" for mixed ones; emits nothing.
    void setValue(std::optional<double> value);
    /// Sets what is shown for mixed values; empty: "—".
    void setMixedText(const QString &text);
    std::optional<double> value() const { return m_value; }

    /// Why a text is no number for a field with this unit, in a sentence.
    static QString whyUnread(const QString &text, const QString &unit, double resolution = 0);

signals:
    /// The user has entered a valid number, by Return or by leaving the field.
    void entered(double value);
    /// Each of the mixed values is to change ("*1.2", "+2"). `map` gives the new value of each, and nothing where there
    /// is none.
    void enteredRelative(const suffuse::ValueMap &map);
    /// The user has stepped the number by the arrow keys or the wheel.
    void stepped(double value);
    /// The same where the values are mixed: each of them is to go up by so many steps.
    void steppedMixed(double steps);
    /// The typed text was refused, and `hint` says why. An empty hint: all is well again.
    void refused(const QString &hint);

protected:
    void keyPressEvent(QKeyEvent *event) override;
    void wheelEvent(QWheelEvent *event) override;
    void focusInEvent(QFocusEvent *event) override;
    void showEvent(QShowEvent *event) override;
    QSize sizeHint() const override;
    QSize minimumSizeHint() const override;

private:
    void take(const QString &typedText);
    QString inWords(double value) const;
    QString rangeHint(double value) const;
    void complain(const QString &hint); ///< an empty hint takes the complaint back
    void stepBy(double steps);
    void show(std::optional<double> value);

    double m_minimum = 0;
    double m_maximum = 1;
    double m_step = 0;
    bool m_integer = false;
    bool m_complains = false; ///< the last typed text was refused
    Display m_display;
    QString m_mixedText;
    std::optional<double> m_value;
};

} // namespace suffuse
