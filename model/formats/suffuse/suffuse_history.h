// Undo steps as the bytes of a chunk beside the picture (docs/file-format.md, "Undo history").
#pragma once

#include "model/document/edit.h"
#include "model/result.h"

#include <QByteArray>
#include <QString>

#include <vector>

namespace suffuse {

struct HistoryStep {
    QString text; ///< its name
    Edit edit;    ///< exchanged: the state before the step while it is done, the one after it while it is undone
};

struct UndoHistory {
    std::vector<HistoryStep> steps;
    std::size_t done = 0; ///< so many of them; the others are undone
};

/// Steps that are kept in a file, the nearest ones.
inline constexpr std::size_t mostHistorySteps = 1000;

/// States that the painting holds, or that steps share, are stored once. Empty where there is no step.
QByteArray writeHistory(const UndoHistory &history, const Painting &painting);

/// Every step is tried, so that a history that fits can be walked to both ends. Errors say why it does not fit.
Result<UndoHistory> readHistory(const QByteArray &bytes, const Painting &painting);

} // namespace suffuse
