#include "render/simd_targets.h"

#include "hwy/highway.h"
#include "model/environment.h"

#include <string>

namespace suffuse {

void useWantedSimd()
{
    const std::string wanted = environment::value(environment::Variable::Simd);
    for (std::int64_t bit = 1; bit > 0 && !wanted.empty(); bit <<= 1)
        if ((hwy::SupportedTargets() & bit) && hwy::TargetName(bit) == wanted) {
            hwy::SetSupportedTargetsForTest(bit);
            return;
        }
}

} // namespace suffuse
