// The text of an InkML trace: values of channels, as they are or as differences.
#pragma once

#include <optional>
#include <string_view>
#include <vector>

namespace suffuse {

/// The values of a trace's points, `channels` numbers for each. A value stands as it is, or, from a sign on and until
/// another one, as the difference from the one before (') or as the difference of that ("). No value where the text is
/// damaged, has more than `most` points, or a number beyond ±1e15. The last of the channels may lack at the end of a
/// point, where they are as before; these are `optional` many.
std::optional<std::vector<double>> traceValues(std::string_view text, std::size_t channels, std::size_t optional,
                                               std::size_t most);

} // namespace suffuse
