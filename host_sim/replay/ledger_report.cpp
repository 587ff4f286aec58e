#include "host_sim/replay/ledger_report.hpp"

#include <cstdio>
#include <filesystem>
#include <nlohmann/json.hpp>

#include "host_sim/atomic_file.hpp"
#include "host_sim/json_text.hpp"
#include "host_sim/reports/run_folder.hpp"

namespace tedavis::host_sim {
namespace {

using Json = nlohmann::ordered_json;

Json fates_json(const LedgerPrice& price) {
    Json fates = Json::array();
    for (const LedgerFate& fate : price.fates) {
        Json one{{"state", fate.state == display::EffectState::replaced ? "replaced" : "skipped"}};
        if (!fate.replaced_by.empty()) one["replaced_by"] = fate.replaced_by;
        one["reason"] = fate.reason;
        one["frames"] = fate.frames;
        fates.push_back(one);
    }
    return fates;
}

Json price_json(const LedgerPrice& price) {
    return {{"ms_saved", price.saved.ms},
            {"ms_spread", price.saved.spread_ms},
            {"delta_e_mean", price.difference.mean},
            {"delta_e_max", price.difference.largest},
            {"edge_difference", price.difference.edges},
            {"worst_frame", price.worst_frame}};
}

std::string name_of(const LedgerPrice& price) { return price.effect.empty() ? "all" : price.effect; }

}  // namespace

std::string ledger_json(const std::vector<LedgerPrice>& prices, const std::vector<LedgerSample>& samples,
                        const std::string& device) {
    Json json{{"device", device}, {"reference", kLedgerReference}, {"frames", Json::array()}, {"effects", Json::array()}};
    for (const LedgerSample& sample : samples) json["frames"].push_back(sample.frame);
    for (const LedgerPrice& price : prices) {
        Json one = price_json(price);
        if (price.effect.empty()) {
            json["all"] = one;
            continue;
        }
        Json named{{"effect", price.effect}, {"fates", fates_json(price)}};
        named.update(one);
        json["effects"].push_back(named);
    }
    return json_text(json, 2) + "\n";
}

std::string ledger_text(const std::vector<LedgerPrice>& prices) {
    std::string text = "  effect                  saves ms      +-   dE mean   dE max    edges  instead";
    for (const LedgerPrice& price : prices) {
        char line[160];
        std::snprintf(line, sizeof line, "\n  %-22s %9.2f %7.2f %9.3f %8.2f %8.3f  ", name_of(price).c_str(), price.saved.ms,
                      price.saved.spread_ms, price.difference.mean, price.difference.largest, price.difference.edges);
        text += line;
        if (price.effect.empty()) text += "as the device showed it";
        for (const LedgerFate& fate : price.fates)
            text += (&fate == price.fates.data() ? "" : "; ") + (fate.replaced_by.empty() ? "nothing" : fate.replaced_by) + ": " +
                    fate.reason;
    }
    return text;
}

void write_ledger(const std::string& folder, const std::string& json, const std::vector<LedgerPrice>& prices) {
    const std::string pictures = folder + "/" + kLedgerFolder;
    std::error_code ignored;
    std::filesystem::remove_all(pictures, ignored);
    make_folder(pictures);
    for (const LedgerPrice& price : prices) {
        write_png(pictures + "/" + name_of(price) + "_intended.png", view_of(price.intended));
        write_png(pictures + "/" + name_of(price) + "_shown.png", view_of(price.shown));
    }
    write_file_atomically(folder + "/" + kLedgerName, json);
}

}  // namespace tedavis::host_sim
