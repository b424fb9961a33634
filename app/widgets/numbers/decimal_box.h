#pragma once

#include "app/widgets/numbers/display.h"

#include <QDoubleSpinBox>
#include <QSpinBox>

#include <optional>

namespace suffuse {

/// A spin box that reads numbers as all other fields do (`evaluateArithmetic`): 12.5 and 12,5 are the same in every
/// language, and "12*1.5" or "50" with the box's unit are understood. Qt's own takes the other language's decimal sign
/// for one that groups digits, and makes 125 of it. Return on what cannot be read, or is out of range, does nothing
/// else than say so: a dialog is not confirmed with another number than the one that stands there.
class DecimalBox : public QDoubleSpinBox {
    Q_OBJECT

public:
    using QDoubleSpinBox::QDoubleSpinBox;

    /// Shows and reads the value by a factor and in its unit, with at most two decimals, of inches three. A number that
    /// nobody touches keeps the digits that are not shown.
    void setDisplay(const Display &display);
    QString textFromValue(double value) const override;
    /// A number in a sentence, with as many digits as tell it from its neighbours.
    QString inWords(double value) const;
    /// The unit in which numbers are typed where they have none; that of the suffix unless a display says it.
    QString unit() const { return (m_display ? m_display->unit : suffix()).trimmed(); }
    double valueFromText(const QString &text) const override;
    QValidator::State validate(QString &text, int &position) const override;

protected:
    void keyPressEvent(QKeyEvent *event) override;
    void focusOutEvent(QFocusEvent *event) override;

private:
    std::optional<double> read(const QString &text) const;
    int finestDecimals() const;
    QString shownText(double value, int decimals) const;

    std::optional<Display> m_display;
};

/// The same for whole numbers, to which results are rounded. What is typed counts when it is finished.
class WholeBox : public QSpinBox {
    Q_OBJECT

public:
    explicit WholeBox(QWidget *parent = nullptr);

    int valueFromText(const QString &text) const override;
    QValidator::State validate(QString &text, int &position) const override;

protected:
    void keyPressEvent(QKeyEvent *event) override;
    void focusOutEvent(QFocusEvent *event) override;

private:
    std::optional<double> read(const QString &text) const;
};

} // namespace suffuse
