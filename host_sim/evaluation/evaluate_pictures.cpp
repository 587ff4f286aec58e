#include "host_sim/evaluation/evaluate_pictures.hpp"

#include <algorithm>
#include <atomic>
#include <filesystem>
#include <map>
#include <nlohmann/json.hpp>
#include <set>

#include "host_sim/evaluation/clutter_opinions.hpp"
#include "host_sim/evaluation/layer_names_beside.hpp"
#include "host_sim/evaluation/picture_file.hpp"
#include "host_sim/input_file.hpp"
#include "host_sim/layer_mask.hpp"
#include "host_sim/reports/drawn_sheet.hpp"
#include "host_sim/user_error.hpp"

namespace tedavis::host_sim {
namespace {

std::string file_name(const std::string& path) { return std::filesystem::path(path).filename().string(); }

void require_other_outputs(const std::vector<std::string>& files, const std::vector<std::string>& names,
                           const std::string& folder) {
    std::set<std::string> outputs;
    for (const std::string& name : names)
        for (const std::string& view : all_view_files(name)) outputs.insert(view);
    for (const std::string& file : files)
        if (outputs.count(file_name(file)) > 0) require_other_file(folder + "/" + file_name(file), {file});
}

/// Views of pictures that do not become part of the result are removed again: all where one picture is faulty, and where the work
/// is stopped those behind the last one.
class WrittenViews {
public:
    WrittenViews(const std::string& folder, const std::vector<std::string>& names)
        : folder_(folder), names_(names), is_written_(names.size()) {}
    ~WrittenViews() {
        for (std::size_t n = are_kept_ ? kept_ : 0; n < names_.size(); ++n)
            if (is_written_[n] != 0) remove(n);
    }
    WrittenViews(const WrittenViews&) = delete;
    WrittenViews& operator=(const WrittenViews&) = delete;

    /// Before the first of its views is written; from any thread, each index once.
    void add(std::size_t n) { is_written_[n] = 1; }
    void keep_until(std::size_t end) { kept_ = end; }
    void keep_only_those() { are_kept_ = true; }

private:
    void remove(std::size_t n) const {
        std::error_code ignored;
        for (const std::string& view : all_view_files(folder_ + "/" + names_[n])) std::filesystem::remove(view, ignored);
    }

    const std::string& folder_;
    const std::vector<std::string>& names_;
    std::vector<std::uint8_t> is_written_;
    std::size_t kept_ = 0;
    bool are_kept_ = false;
};

}  // namespace

std::vector<std::string> view_names(const std::vector<std::string>& files) {
    std::vector<std::string> names;
    std::set<std::string> taken;
    std::map<std::string, int> numbers;
    for (const std::string& file : files) {
        const std::string stem = std::filesystem::path(file).stem().string();
        std::string name = stem;
        for (int& n = numbers[stem]; !taken.insert(name).second;) name = stem + "-" + std::to_string(n = std::max(n, 1) + 1);
        names.push_back(name);
    }
    return names;
}

std::vector<std::string> pictures_of_sheets(const std::vector<std::string>& inputs) {
    std::vector<std::string> files;
    for (const std::string& input : inputs) {
        const std::string record = input + "/" + kSheetJsonName;
        if (!std::filesystem::is_regular_file(record)) {
            if (!is_layer_mask(input)) files.push_back(input);
            continue;
        }
        const auto sheet = nlohmann::json::parse(read_file(record), nullptr, false);
        const auto pictures = sheet.is_object() ? sheet.value("pictures", nlohmann::json::array()) : nlohmann::json::array();
        if (!pictures.is_array() || pictures.empty()) throw UserError(record + ": names no pictures; write the sheet again");
        for (const auto& picture : pictures) files.push_back(input + "/" + picture.value("file", ""));
    }
    return files;
}

std::vector<std::vector<const Fixation*>> gaze_of_pictures(const FixationFile& file, const std::vector<std::string>& pictures) {
    if (!file.has_files && pictures.size() > 1)
        throw UserError(file.path + ":1: no column file; it says which of the " + std::to_string(pictures.size()) +
                        " pictures a fixation is on");
    std::vector<std::vector<const Fixation*>> gaze(pictures.size());
    for (const Fixation& fixation : file.fixations) {
        for (std::size_t n = 0; n < pictures.size(); ++n)
            if (!file.has_files || fixation.file == pictures[n] || fixation.file == file_name(pictures[n]))
                gaze[n].push_back(&fixation);
    }
    return gaze;
}

OpinionsAgreement agreement_over_pictures(const std::vector<EvaluatedPicture>& pictures) {
    std::vector<double> clutter;
    std::vector<ClutterOpinions> opinions;
    for (const EvaluatedPicture& one : pictures) {
        if (!one.measures.opinions) continue;
        clutter.push_back(one.measures.clutter);
        opinions.push_back(*one.measures.opinions);
    }
    return opinions_agreement(clutter, opinions);
}

std::vector<EvaluatedPicture> evaluate_pictures(const std::vector<std::string>& files, const std::string& folder,
                                                const FixationFile* file, const EvaluationWork& work) {
    const std::vector<std::string> names = view_names(files);
    require_other_outputs(files, names, folder);
    std::vector<std::vector<const Fixation*>> gaze;
    if (file != nullptr) gaze = gaze_of_pictures(*file, files);
    std::vector<EvaluatedPicture> evaluated;
    WrittenViews written(folder, names);
    std::atomic<std::size_t> hits = 0;
    const auto measure = [&](PictureMeter& meter, std::size_t n) {
        const RgbaPicture picture = read_picture(files[n]);
        const auto mask = read_layer_mask(files[n], layer_names_beside(files[n]), picture.width, picture.height);
        const std::vector<GazePixel> pixels =
            file == nullptr ? std::vector<GazePixel>() : gaze_pixels(*file, gaze[n], picture.width, picture.height);
        hits += pixels.size();
        PictureMeasures measures = meter.measure(picture, files[n], mask ? &*mask : nullptr, pixels);
        const MeasuredOpinions opinions = clutter_opinions(picture);
        measures.opinions = opinions.numbers;
        const PictureViews views = picture_views(picture, meter, measures, opinions.congestion, work.settings);
        written.add(n);
        write_views(folder, names[n], file_name(files[n]), picture, views, measures);
        return EvaluatedPicture{files[n], names[n], std::move(measures)};
    };
    (void)for_each_picture(work, "pictures", files.size(), measure, [&](std::size_t n, EvaluatedPicture&& one) {
        evaluated.push_back(std::move(one));
        written.keep_until(n + 1);
    });
    written.keep_only_those();
    const bool is_whole = evaluated.size() == files.size();
    const std::string missed = file == nullptr || !is_whole ? std::string() : words_about_missed(*file, hits);
    if (!missed.empty()) work.console.note(missed);
    return evaluated;
}

}  // namespace tedavis::host_sim
