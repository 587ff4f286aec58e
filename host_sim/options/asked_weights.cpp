#include "host_sim/options/asked_weights.hpp"

#include <charconv>
#include <sstream>

#include "host_sim/user_error.hpp"

namespace tedavis::host_sim {
namespace {

[[noreturn]] void refuse(const std::string& text) {
    throw UserError("weights \"" + text + "\": write names with numbers from 0 to 1, such as terrain=0.3,data=1");
}

}  // namespace

AskedWeights weights_from(const std::string& text) {
    AskedWeights weights;
    std::istringstream parts(text);
    for (std::string part; std::getline(parts, part, ',');) {
        const std::size_t sign = part.find('=');
        if (sign == 0 || sign == std::string::npos) refuse(text);
        double weight = -1;
        const char *begin = part.data() + sign + 1, *end = part.data() + part.size();
        const auto read = std::from_chars(begin, end, weight);
        const bool is_weight = read.ec == std::errc() && read.ptr == end && weight >= 0 && weight <= 1;
        if (!is_weight) refuse(text);
        const std::string name = part.substr(0, sign);
        if (!weights.emplace(name, weight).second)
            throw UserError("weights \"" + text + "\": '" + name + "' has two weights; leave one out");
    }
    if (weights.empty()) refuse(text);
    return weights;
}

std::string text_of(const AskedWeights& weights) {
    std::ostringstream text;
    for (const auto& [name, weight] : weights) text << (text.tellp() > 0 ? "," : "") << name << '=' << weight;
    return text.str();
}

}  // namespace tedavis::host_sim
