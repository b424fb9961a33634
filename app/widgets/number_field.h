#pragma once

#include "app/widgets/display.h"

#include <QLineEdit>

#include <functional>
#include <optional>

namespace suffuse {

/// From a value to the one that takes its place.
using ValueMap = std::function<std::optional<double>(double)>;

/// A field for one number with a unit: takes arithmetic ("12*1.5", "+2"), steps by arrow keys and the wheel, and shows
/// "—" where several values are mixed, each of which "*1.2" or "+2" then changes. A number outside the range is
/// refused, never clamped in silence.
class NumberField : public QLineEdit {
    Q_OBJECT

public:
    explicit NumberField(QWidget *parent = nullptr);

    /// Closed range; ends that are open in the domain are given as the smallest value allowed.
    void setRange(double minimum, double maximum);
    double minimum() const { return m_minimum; }
    double maximum() const { return m_maximum; }
    /// Shown behind the number, " s" or " %"; taken off again where typed.
    void setUnit(const QString &unit);
    /// Unit, factor, sense and decimals of what is shown and typed.
    void setDisplay(const Display &display);
    /// A step of the arrow keys: so much, or where 0 a tenth of the value.
    void setStep(double step) { m_step = step; }
    /// Whole numbers only.
    void setInteger(bool integer)
    {
        m_integer = integer;
        m_display.decimals = integer ? 0 : -1;
    }

    /// Shows a value, or mixed; emits nothing.
    void setValue(std::optional<double> value);
    std::optional<double> value() const { return m_value; }

signals:
    /// A valid number was entered (Return, leaving the field).
    void entered(double value);
    /// Values are mixed and each is to change ("*1.2", "+2"): `map` gives the new one of each, nothing where it cannot.
    void enteredRelative(const suffuse::ValueMap &map);
    /// The number was stepped by the arrow keys or the wheel.
    void stepped(double value);
    /// What was typed was refused; `hint` says why, empty: all is well again.
    void refused(const QString &hint);

protected:
    bool event(QEvent *event) override;
    void keyPressEvent(QKeyEvent *event) override;
    void wheelEvent(QWheelEvent *event) override;
    void focusInEvent(QFocusEvent *event) override;
    QSize sizeHint() const override;
    QSize minimumSizeHint() const override;

private:
    void commit();
    QString whyRefused(const QString &text) const;
    QString rangeHint(double value) const;
    void complain(const QString &hint); ///< empty: all is well again
    void stepBy(double steps);
    void show(std::optional<double> value);

    double m_minimum = 0;
    double m_maximum = 1;
    double m_step = 0;
    bool m_integer = false;
    bool m_complains = false; ///< what was typed last was refused
    Display m_display;
    QString m_shown;
    std::optional<double> m_value;
};

} // namespace suffuse
