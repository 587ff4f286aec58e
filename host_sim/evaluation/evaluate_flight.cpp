#include "host_sim/evaluation/evaluate_flight.hpp"

#include <algorithm>
#include <atomic>

#include "host_sim/evaluation/clutter_opinions.hpp"
#include "host_sim/evaluation/evaluation_files.hpp"
#include "host_sim/evaluation/picture_file.hpp"
#include "host_sim/evaluation/plan_lines.hpp"
#include "host_sim/user_error.hpp"

namespace tedavis::host_sim {
namespace {

/// The longest time that a frame stays: of the last one, as long as the one before it.
double last_frame_s(const FlightRun& run) {
    const std::size_t count = run.frames.size();
    return count < 2 ? 1.0 : run.frames[count - 1].time_s - run.frames[count - 2].time_s;
}

PictureMeasures measure_frame(PictureMeter& meter, const FlightFrame& frame, const RgbaPicture& picture,
                              const std::vector<GazePixel>& gaze) {
    const auto mask = read_layer_mask(frame.picture, frame.layers, picture.width, picture.height);
    return meter.measure(picture, frame.picture, mask ? &*mask : nullptr, gaze);
}

}  // namespace

std::vector<std::vector<const Fixation*>> gaze_of_flight(const FixationFile& file, const FlightRun& run) {
    if (!file.has_times)
        throw UserError(file.path +
                        ":1: no column time_s; gaze over a flight needs the time of each fixation, as in frames.jsonl");
    std::vector<std::vector<const Fixation*>> gaze(run.frames.size());
    const double end_s = run.frames.back().time_s + last_frame_s(run);
    for (const Fixation& fixation : file.fixations) {
        const double time_s = *fixation.time_s;
        const auto after = std::upper_bound(run.frames.begin(), run.frames.end(), time_s,
                                            [](double t, const FlightFrame& frame) { return t < frame.time_s; });
        if (after != run.frames.begin() && time_s < end_s)
            gaze[static_cast<std::size_t>(after - run.frames.begin()) - 1].push_back(&fixation);
    }
    return gaze;
}

EvaluatedFlight measure_flight(FlightRun run, const FixationFile* file, const EvaluationWork& work) {
    EvaluatedFlight flight;
    std::vector<std::vector<const Fixation*>> gaze;
    if (file != nullptr) gaze = gaze_of_flight(*file, run);
    std::atomic<std::size_t> hits = 0;
    const auto measure = [&](PictureMeter& meter, std::size_t n) {
        const RgbaPicture picture = read_picture(run.frames[n].picture);
        const std::vector<GazePixel> pixels =
            file == nullptr ? std::vector<GazePixel>() : gaze_pixels(*file, gaze[n], picture.width, picture.height);
        hits += pixels.size();
        return measure_frame(meter, run.frames[n], picture, pixels);
    };
    EvaluationWork quick = work;
    quick.settings.saliency_start_level = kFlightStartLevel;
    const std::size_t count =
        for_each_picture(quick, run.folder, run.frames.size(), measure,
                         [&](std::size_t, PictureMeasures&& one) { flight.measures.push_back(std::move(one)); });
    if (count == 0) throw Interrupted("interrupted; nothing was written");
    flight.interrupted = count < run.frames.size();
    const std::string missed = file == nullptr || flight.interrupted ? std::string() : words_about_missed(*file, hits);
    if (!missed.empty()) work.console.note(missed);
    run.frames.resize(count);
    flight.run = std::move(run);
    flight.peak_rule = peak_rule_for(times_of(flight), clutter_of(flight));
    return flight;
}

void draw_moments(const std::vector<MomentToDraw>& moments, const std::string& folder, const EvaluationWork& work) {
    const auto draw = [&](PictureMeter& meter, std::size_t n) {
        const MomentToDraw& moment = moments[n];
        const FlightFrame& frame = moment.flight->run.frames[moment.index];
        const RgbaPicture picture = read_picture(frame.picture);
        PictureMeasures measures = measure_frame(meter, frame, picture, {});
        const MeasuredOpinions opinions = clutter_opinions(picture);
        measures.opinions = *moment.opinions = opinions.numbers;
        const PictureViews views = picture_views(picture, meter, measures, opinions.congestion, work.settings);
        write_views(folder, moment.name, moment.title, picture, views, measures);
        return small_views(picture, views);
    };
    EvaluationWork whole = work;
    whole.is_stopped = [] { return false; };
    (void)for_each_picture(whole, "views", moments.size(), draw,
                           [&](std::size_t n, MomentViews&& views) { *moments[n].views = std::move(views); });
    for (const MomentToDraw& moment : moments) {
        const auto records = records_of(moment.flight->run, {moment.flight->run.frames[moment.index].frame});
        *moment.plan = plan_lines(records.front());
    }
}

}  // namespace tedavis::host_sim
