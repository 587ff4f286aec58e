#include "host_sim/replay/generated_flight.hpp"

#include <filesystem>

namespace tedavis::host_sim {

bool is_generated_flight(const std::string& log) {
    std::error_code error;
    return std::filesystem::is_regular_file(std::filesystem::path(log).replace_filename("scenario.json"), error);
}

}  // namespace tedavis::host_sim
