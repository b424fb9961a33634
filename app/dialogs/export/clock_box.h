#pragma once

#include "model/painting/segment.h"

#include <QDoubleSpinBox>

namespace suffuse {

/// A field for a moment of the document. It is shown and typed as clocks do (1:02.345); seconds alone are understood,
/// too.
class ClockBox : public QDoubleSpinBox {
    Q_OBJECT

public:
    explicit ClockBox(QWidget *parent = nullptr);

    Microseconds time() const { return toMicroseconds(value()); }
    void setTime(Microseconds time) { setValue(toSeconds(time)); }

    QString textFromValue(double seconds) const override;
    double valueFromText(const QString &text) const override;
    QValidator::State validate(QString &text, int &position) const override;
};

} // namespace suffuse
