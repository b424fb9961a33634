#pragma once

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

    double valueFromText(const QString &text) const override;
    QValidator::State validate(QString &text, int &position) const override;

protected:
    void keyPressEvent(QKeyEvent *event) override;
    void focusOutEvent(QFocusEvent *event) override;

private:
    std::optional<double> read(const QString &text) const;
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
