// What commands that fit strokes ask of the command line.
#pragma once

#include "app/cli/options.h"

namespace suffuse::cli {

struct NumberRange {
    double least, greatest;
    bool isWhole;
};

/// The number that an option gives, or `usual`.
Result<double> numberOf(const CommandLine &line, const QString &option, double usual, const NumberRange &range);
/// --style; feathering if it is not given.
Result<StyleKind> styleOf(const CommandLine &line);
/// The bytes of a file, or of standard input for "-".
Result<QByteArray> inputBytes(const QString &path);
/// Why OUT cannot be written, found before a minute is spent; or empty.
QString problemOfOut(const QString &out);

} // namespace suffuse::cli
