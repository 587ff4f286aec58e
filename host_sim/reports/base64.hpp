/// Base64 (RFC 4648, section 4) for data URIs.
#pragma once

#include <string>
#include <string_view>

namespace tedavis::host_sim {

[[nodiscard]] std::string base64(std::string_view bytes);

}  // namespace tedavis::host_sim
