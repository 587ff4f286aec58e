#include "host_sim/evaluation/evaluation_json.hpp"

namespace tedavis::host_sim {
namespace {

using Json = nlohmann::ordered_json;

Json canny_json(const perception::CannySettings& canny) {
    return {{"sigma", canny.sigma}, {"low", canny.low}, {"high", canny.high}};
}

Json grid_json(const std::vector<double>& densities, const perception::RegionGrid& grid) {
    Json rows = Json::array();
    for (std::size_t n = 0; n < densities.size(); ++n) {
        if (n % static_cast<std::size_t>(grid.columns) == 0) rows.push_back(Json::array());
        rows.back().push_back(densities[n]);
    }
    return rows;
}

Json shares_json(const std::vector<LayerShare>& layers) {
    Json shares = Json::object();
    for (const LayerShare& layer : layers) shares[layer.layer] = layer.share;
    return layers.empty() ? Json() : shares;
}

Json score_json(const std::optional<GazeScore>& score) {
    if (!score) return {};
    return {{"auc", score->auc}, {"nss", score->nss ? Json(*score->nss) : Json()}, {"pixels", score->pixels}};
}

/// `name`: of its view files; empty where it has none.
Json picture_json(const std::string& file, const PictureMeasures& measures, const std::string& name,
                  const EvaluationSettings& settings) {
    Json json{{"file", file},
              {"size", std::to_string(measures.width) + "x" + std::to_string(measures.height)},
              {"clutter", measures.clutter},
              {"clutter_grid", grid_json(measures.clutter_grid, settings.grid)},
              {"saliency_map", Json()},
              {"saliency_level", measures.saliency_level},
              {"canny", canny_json(settings.canny)}};
    if (!name.empty()) {
        const ViewFiles views = view_files(name);
        json["saliency_map"] = views.saliency;
        json["views"] = {{"heat", views.heat},
                         {"edges", views.edges},
                         {"regions", views.regions},
                         {"congestion", views.congestion},
                         {"second_opinion", views.second_opinion},
                         {"sheet", views.sheet}};
    }
    if (measures.opinions) {
        json["feature_congestion"] = measures.opinions->feature_congestion;
        json["subband_entropy"] = measures.opinions->subband_entropy;
    }
    if (!measures.layers.empty()) json["layer_shares"] = shares_json(measures.layers);
    if (measures.gaze) json["gaze"] = score_json(measures.gaze);
    return json;
}

Json agreement_json(const OpinionsAgreement& agreement) {
    const auto pairs = [](const OrderAgreement& one) { return Json{{"pairs", one.pairs}, {"alike", one.alike}}; };
    return {{"feature_congestion", pairs(agreement.feature_congestion)}, {"subband_entropy", pairs(agreement.subband_entropy)}};
}

Json phases_json(const EvaluatedFlight& flight) {
    Json phases = Json::array();
    for (const SpanSummary& span : summaries_by_phase(flight)) {
        const auto share = prioritized_share(span);
        phases.push_back({{"phase", span.phase},
                          {"from_s", flight.run.frames[span.first].time_s},
                          {"to_s", flight.run.frames[span.end - 1].time_s},
                          {"frames", span.end - span.first},
                          {"clutter_mean", span.mean},
                          {"clutter_highest", span.highest},
                          {"highest_s", flight.run.frames[span.highest_at].time_s},
                          {"comes_first", span.comes_first},
                          {"prioritized", span.prioritized.empty() ? Json() : Json(span.prioritized)},
                          {"prioritized_share", share ? Json(*share) : Json()},
                          {"layer_shares", shares_json(span.layers)}});
    }
    return phases;
}

Json peaks_json(const EvaluatedFlight& flight) {
    Json peaks = Json::array();
    for (const FlightMoment& moment : flight.moments) {
        const FlightFrame& frame = flight.run.frames[moment.index];
        const ViewFiles views = view_files(moment.file);
        Json plan = Json::object();
        for (const auto& [term, words] : moment.plan) plan[term] = words;
        peaks.push_back({{"label", moment.label},
                         {"frame", frame.frame},
                         {"time_s", frame.time_s},
                         {"phase", frame.phase},
                         {"clutter", flight.measures[moment.index].clutter},
                         {"feature_congestion", moment.opinions.feature_congestion},
                         {"subband_entropy", moment.opinions.subband_entropy},
                         {"prominence", moment.prominence},
                         {"saliency_map", views.saliency},
                         {"heat", views.heat},
                         {"edges", views.edges},
                         {"regions", views.regions},
                         {"congestion", views.congestion},
                         {"sheet", views.sheet},
                         {"plan", plan}});
    }
    return peaks;
}

/// Names of view files by frame.
std::string moment_file(const EvaluatedFlight& flight, std::size_t index) {
    for (const FlightMoment& moment : flight.moments)
        if (moment.index == index) return moment.file;
    return {};
}

Json frames_json(const EvaluatedFlight& flight, const EvaluationSettings& settings) {
    Json pictures = Json::array();
    for (std::size_t n = 0; n < flight.measures.size(); ++n) {
        const FlightFrame& frame = flight.run.frames[n];
        Json picture{{"frame", frame.frame}, {"time_s", frame.time_s}, {"phase", frame.phase}};
        picture.update(picture_json(frame.picture, flight.measures[n], moment_file(flight, n), settings));
        pictures.push_back(std::move(picture));
    }
    return pictures;
}

Json flight_json(const EvaluatedFlight& flight, const EvaluationSettings& settings) {
    const SpanSummary all = summary_of(flight, 0, flight.run.frames.size());
    const std::optional<double> share = mean_prioritized_share(flight);
    std::vector<const PictureMeasures*> measures;
    for (const PictureMeasures& one : flight.measures) measures.push_back(&one);
    return {{"run", flight.run.folder},
            {"log", flight.run.log},
            {"design", flight.run.design},
            {"device", flight.run.device},
            {"frames", flight.run.frames.size()},
            {"interrupted", flight.interrupted},
            {"clutter", {{"mean", all.mean}, {"highest", all.highest}, {"highest_s", flight.run.frames[all.highest_at].time_s}}},
            {"layer_shares", shares_json(all.layers)},
            {"prioritized_share", share ? Json(*share) : Json()},
            {"gaze", gaze_summary_json(measures)},
            {"saliency_start_level", kFlightStartLevel},
            {"peak_rule",
             {{"least_prominence", flight.peak_rule.least_prominence},
              {"least_distance_s", flight.peak_rule.least_distance_s},
              {"most", flight.peak_rule.most}}},
            {"phases", phases_json(flight)},
            {"peaks", peaks_json(flight)},
            {"order_agreement", agreement_json(agreement_over_moments(flight))},
            {"pictures", frames_json(flight, settings)}};
}

Json difference_json(const PhaseDifference& one) {
    return {{"phase", one.phase},
            {"from_s", one.begin_s},
            {"to_s", one.end_s},
            {"frames", one.frames},
            {"clutter_mean", {one.mean_a, one.mean_b}},
            {"clutter_highest", {one.highest_a, one.highest_b}},
            {"change", one.mean_b - one.mean_a}};
}

}  // namespace

Json gaze_summary_json(const std::vector<const PictureMeasures*>& pictures) {
    double auc = 0, nss = 0;
    std::size_t count = 0, count_with_nss = 0;
    for (const PictureMeasures* picture : pictures) {
        if (!picture->gaze) continue;
        ++count;
        auc += picture->gaze->auc;
        if (picture->gaze->nss) nss += *picture->gaze->nss, ++count_with_nss;
    }
    if (count == 0) return {};
    return {{"pictures", count},
            {"auc", auc / static_cast<double>(count)},
            {"nss", count_with_nss > 0 ? Json(nss / static_cast<double>(count_with_nss)) : Json()}};
}

Json pictures_json(const std::vector<EvaluatedPicture>& pictures, const EvaluationSettings& settings, bool interrupted) {
    std::vector<const PictureMeasures*> measures;
    for (const EvaluatedPicture& one : pictures) measures.push_back(&one.measures);
    Json json{{"interrupted", interrupted}, {"gaze", gaze_summary_json(measures)}, {"pictures", Json::array()}};
    for (const EvaluatedPicture& one : pictures)
        json["pictures"].push_back(picture_json(one.file, one.measures, one.name, settings));
    json["order_agreement"] = agreement_json(agreement_over_pictures(pictures));
    return json;
}

Json flights_json(const FlightReport& report) {
    if (!report.comparison) return flight_json(report.flights.front(), report.settings);
    Json json{{"runs", Json::array()}, {"differences", Json::object()}};
    for (const EvaluatedFlight& flight : report.flights) json["runs"].push_back(flight_json(flight, report.settings));
    Json phases = Json::array();
    for (const PhaseDifference& one : report.comparison->phases) phases.push_back(difference_json(one));
    json["differences"] = {{"frames", report.comparison->pairs.size()},
                           {"only_a", report.comparison->only_a},
                           {"only_b", report.comparison->only_b},
                           {"all", difference_json(report.comparison->all)},
                           {"phases", phases}};
    return json;
}

}  // namespace tedavis::host_sim
