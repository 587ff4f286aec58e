/// A design with all that it inherits, as `tedavis check --resolved` prints it.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>

namespace tedavis::host_sim {

/// Returns the keys of the file and of the designs that it inherits from. Written to a file of the same name and folder, they are
/// the same design, without inheritance. Throws UserError with file and line.
[[nodiscard]] nlohmann::ordered_json resolved_design(const std::string& path);

}  // namespace tedavis::host_sim
