#include "host_sim/replay/read_switch_log.hpp"

#include "bus/switches/switch_log.hpp"
#include "host_sim/input_file.hpp"
#include "host_sim/user_error.hpp"

namespace tedavis::host_sim {

std::string read_switch_log(const std::string& path) {
    std::string text = read_file(path);
    if (bus::has_switch_log_header(text)) return text;
    const std::string_view header = bus::kSwitchLogHeader;
    throw UserError(path + ":1: not a switch log; give one whose first line is '" +
                    std::string(header.substr(0, header.size() - 1)) + "'");
}

}  // namespace tedavis::host_sim
