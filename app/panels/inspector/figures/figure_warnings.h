// Warnings about values that defeat their purpose.
#pragma once

#include "app/panels/inspector/figures/figures_summary.h"

#include <QStringList>

namespace suffuse {

/// Translated sentences, each of them once and the gravest first; empty where there is nothing to warn of.
QStringList figureWarnings(const FiguresSummary &figures);

} // namespace suffuse
