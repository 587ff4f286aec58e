/// A design with all that it inherits, as `tedavis check --resolved` prints it.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>

namespace tedavis::host_sim {

/// What the file says and its bases add; with the same name and in the same folder it is the same design, based on none. Throws
/// UserError with file and line.
[[nodiscard]] nlohmann::ordered_json resolved_design(const std::string& path);

}  // namespace tedavis::host_sim
