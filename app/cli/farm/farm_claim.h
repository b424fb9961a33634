// To which farm a picture belongs: two farms would overwrite each other's pieces.
#pragma once

#include "app/cli/farm/farm_plan.h"

namespace suffuse::cli {

/// The mark beside a picture that names the farm's folder: a hidden file, which `claimOuts` writes.
QString claimOf(const FarmPainting &painting);

/// Empty if all pictures of a plan are the plan's or nobody's. Otherwise it says to which other farm one belongs, and what
/// to do. A farm whose folder has no plan any more, or a plan of other pictures, owns nothing.
QString problemOfClaims(const FarmPlan &plan);
/// Marks all pictures of a plan as its own. Of two plans that do so at once the second one fails.
Result<void> claimOuts(const FarmPlan &plan);
/// Takes the marks away: what is joined is finished, and belongs to whoever has it.
void releaseOuts(const FarmPlan &plan);

} // namespace suffuse::cli
