// What a painter should know about values that defeat their purpose.
#pragma once

#include "app/panels/inspector/figures_summary.h"

#include <QStringList>

namespace suffuse {

/// Translated sentences, each once, the gravest first; empty where all is well.
QStringList figureWarnings(const FiguresSummary &figures);

} // namespace suffuse
