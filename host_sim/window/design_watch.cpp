#include "host_sim/window/design_watch.hpp"

#include <algorithm>

#include "host_sim/input_file.hpp"
#include "host_sim/user_error.hpp"

namespace tedavis::host_sim {

DesignWatch::DesignWatch(const PictureOptions& options) : options_(options) {
    options_.design = design_path(options);
    designs_ = load_designs(options_, &taken_);
}

DesignNews DesignWatch::look() {
    std::vector<std::string> met;
    try {
        for (const ReadFile& file : taken_) met.push_back(read_file(file.path));
    } catch (const UserError&) {
        return DesignNews::none;  // editors take a file away for a moment while they save
    }
    const bool settled = met == last_met_;
    last_met_ = met;
    const bool same = std::equal(met.begin(), met.end(), taken_.begin(), taken_.end(),
                                 [](const std::string& text, const ReadFile& file) { return text == file.text; });
    if (!settled || same) return DesignNews::none;
    try {
        designs_ = load_designs(options_, &taken_);
        return DesignNews::changed;
    } catch (const UserError& error) {
        message_ = error.what();
        return DesignNews::broken;
    }
}

}  // namespace tedavis::host_sim
