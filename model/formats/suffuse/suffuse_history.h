// Undo steps as the bytes of a chunk besides the picture (docs/file-format.md, "Undo history").
#pragma once

#include "model/document/edit.h"
#include "model/result.h"

#include <QByteArray>
#include <QString>

#include <vector>

namespace suffuse {

struct HistoryStep {
    QString text; ///< the name of the step
    /// an exchanged edit: it has the state before the step while that is done, and the state after it while it is
    /// undone
    Edit edit;
};

struct UndoHistory {
    std::vector<HistoryStep> steps;
    std::size_t done = 0; ///< so many of the steps are done; the others are undone
};

/// At most so many steps are kept in a file: those nearest to the present one.
inline constexpr std::size_t mostHistorySteps = 1000;

/// Writes a history. States that the painting has, or that several steps have, are stored once. Empty if there is no
/// step.
QByteArray writeHistory(const UndoHistory &history, const Painting &painting);

/// Reads a history. Every step is tried, so that a history that fits can be walked through to both ends. Errors say why
/// it does not fit.
Result<UndoHistory> readHistory(const QByteArray &bytes, const Painting &painting);

} // namespace suffuse
