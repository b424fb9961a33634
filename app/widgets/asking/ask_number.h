// Asks for one number.
#pragma once

#include <QString>

#include <optional>

class QWidget;

namespace suffuse {

struct NumberQuestion {
    QString title;
    QString label;
    double value = 0; ///< that stands there first
    double minimum = 0, maximum = 1;
    int decimals = 3;
    bool isLength = false; ///< of the canvas, canvas units: it is asked for as the parent's window shows lengths
};

/// Asks in a dialog whose field reads numbers as all others do (`DecimalBox`). No value: it was cancelled.
std::optional<double> askNumber(QWidget *parent, const NumberQuestion &question);

} // namespace suffuse
