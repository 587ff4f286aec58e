#include "host_sim/flight_test/text_condition.hpp"

#include <algorithm>
#include <cstdio>
#include <optional>
#include <string_view>

#include "host_sim/flight_test/nearest_names.hpp"
#include "host_sim/flight_test/text_in_pixels.hpp"
#include "render_core/draw/font_atlas.hpp"

namespace tedavis::host_sim {
namespace {

/// Boxes whose numbers move past a value.
const std::vector<std::string> kBoxesWithMarks = {"", "airspeed", "altitude", "vertical_speed", "heading", "attitude"};

constexpr const char* kOtherCase = "the words are written in another case, and upper and lower case count";

bool lies_in_box(const PlacedWords& words, const std::string& box) {
    return box.empty() || std::find(words.boxes.begin(), words.boxes.end(), box) != words.boxes.end();
}

/// The character from a byte on.
std::string character_at(const std::string& text, std::size_t at) {
    std::string_view rest = std::string_view(text).substr(at);
    const std::size_t before = rest.size();
    static_cast<void>(draw::take_code_point(rest));
    return text.substr(at, before - rest.size());
}

/// A text that the frame writes, and the character of it that is seen least.
struct WrittenText {
    const PlacedWords* words = nullptr;
    CharacterLook faintest;
};

std::string words_of_covered(const WrittenText& text) {
    char place[128];
    std::snprintf(place, sizeof place, "' at x %.0f, y %.0f look like it by %.2f of 1, and %.2f is needed",
                  static_cast<double>(text.faintest.x), static_cast<double>(text.faintest.y), text.faintest.correlation,
                  kSeenCorrelation);
    return "it is written, but not seen: the pixels of '" + character_at(text.words->text, text.faintest.at) + place;
}

/// Of all places where the frame writes it, the one that is seen best.
std::optional<WrittenText> best_seen(const ObservedFrame& frame, const std::string& says, const std::string& box) {
    std::optional<WrittenText> best;
    for (const PlacedWords& words : frame.words) {
        if (!lies_in_box(words, box)) continue;
        for (const std::size_t at : places_of_words(words.text, says)) {
            const auto look = frame.picture == nullptr ? std::nullopt
                                                       : faintest_character(frame.picture->pixels(), words, at, at + says.size());
            const CharacterLook faintest =
                look.value_or(CharacterLook{at, frame.picture == nullptr ? 1.0 : 0.0, words.x, words.y});
            if (!best || faintest.correlation > best->faintest.correlation) best = {&words, faintest};
        }
    }
    return best;
}

std::vector<std::string> texts_in_box(const ObservedFrame& frame, const std::string& box) {
    std::vector<std::string> texts;
    for (const PlacedWords& words : frame.words)
        if (lies_in_box(words, box)) texts.push_back(words.text);
    return texts;
}

std::string in_lower_case(std::string text) {
    for (char& c : text)
        if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
    return text;
}

std::string quoted(const std::string& text) { return "\"" + text + "\""; }

/// A text with these words in whatever case; null where none has them.
const std::string* in_any_case(const std::vector<std::string>& texts, const std::string& says) {
    const std::string lower = in_lower_case(says);
    const auto found =
        std::find_if(texts.begin(), texts.end(), [&](const std::string& text) { return has_words(in_lower_case(text), lower); });
    return found == texts.end() ? nullptr : &*found;
}

/// Those with the words in another case first, then by their distance.
void put_most_similar_first(std::vector<std::string>& texts, const std::string& says) {
    const std::string lower = in_lower_case(says);
    const auto distance = [&](const std::string& text) {
        return has_words(in_lower_case(text), lower) ? std::size_t{0} : edit_distance(in_lower_case(text), lower);
    };
    std::stable_sort(texts.begin(), texts.end(),
                     [&](const std::string& a, const std::string& b) { return distance(a) < distance(b); });
}

/// Of texts of which none has the words: all of them where they are few, else how many and the most similar ones.
std::string words_of_others(std::vector<std::string> texts, const std::string& says) {
    constexpr std::size_t kFew = 12, kNearest = 3;
    if (texts.empty()) return "no text";
    std::string count, list;
    if (texts.size() > kFew) {
        count = std::to_string(texts.size()) + " texts, the most similar ones ";
        put_most_similar_first(texts, says);
        texts.resize(kNearest);
    }
    for (const std::string& text : texts) list += (list.empty() ? "" : ", ") + quoted(text);
    return count + list;
}

/// Why a text is not found: another case, or another place.
std::string reason_of_missing(const ObservedFrame& frame, const std::vector<std::string>& texts, const std::string& says) {
    if (in_any_case(texts, says) != nullptr) return kOtherCase;
    for (const PlacedWords& words : frame.words)
        if (has_words(words.text, says) && !words.boxes.empty()) return "it is written in " + words.boxes.front();
    return texts.empty() ? "nothing is written there" : "no text there has these words";
}

/// A text of the symbology; `box` is empty for one anywhere. The frame must write it, and its pixels must show it.
Observation observe_text(const ObservedFrame& frame, const std::string& says, const std::string& box) {
    const std::optional<WrittenText> text = best_seen(frame, says, box);
    if (text && text->faintest.correlation >= kSeenCorrelation) return {true, quoted(text->words->text), {}};
    if (text) return {false, words_of_covered(*text), "something covers it, or it has nearly the color of its ground"};
    const std::vector<std::string> texts = texts_in_box(frame, box);
    return {false, words_of_others(texts, says), reason_of_missing(frame, texts, says)};
}

/// A text that the frame must not write, in whatever case: a misspelled word is never written, and would prove nothing.
Observation observe_no_text(const ObservedFrame& frame, const std::string& says, const std::string& box) {
    const std::vector<std::string> texts = texts_in_box(frame, box);
    const std::string* const found = in_any_case(texts, says);
    if (found == nullptr) return {true, "no such text", {}};
    return {false, quoted(*found), has_words(*found, says) ? "it is written" : kOtherCase};
}

/// What is wrong with a text that is asked for; empty where nothing is.
std::string fault_of_text(const std::string& says, const std::string& box) {
    if (says.empty()) return "'text' needs says, such as { says = \"TERRAIN AHEAD\" }";
    if (const std::string strange = unwritable_character(says); !strange.empty())
        return "'says': the display's typeface has no '" + strange + "'; remove it";
    const bool is_number = says.find_first_not_of("0123456789+-. ") == std::string::npos;
    if (is_number && std::find(kBoxesWithMarks.begin(), kBoxesWithMarks.end(), box) != kBoxesWithMarks.end())
        return "'says': \"" + says + "\" may be a mark of a scale; say values = { indicated_airspeed_kt = [89, 91] } or the like";
    return {};
}

/// text = { says = "TERRAIN AHEAD", in = "annunciations", there = true }, or a list of such.
void read_text_condition(const ScriptValue& value, ScriptFaults& faults, std::vector<FrameCondition>& conditions) {
    if (value.kind != ScriptValue::Kind::table)
        return faults.add(value.file, value.line, "'text' must be a table such as { says = \"TERRAIN AHEAD\" }");
    ScriptTable text(value, faults);
    const std::size_t before = faults.count();
    const std::string says = with_single_blanks(text.text("says").value_or(""));
    const std::string box = text.text("in").value_or("");
    const bool is_there = text.boolean("there").value_or(true);
    text.finish();
    if (!box.empty() && !place_among(text, "in", box, layout_box_names())) return;
    if (faults.count() != before) return;
    if (const std::string message = fault_of_text(says, box); !message.empty()) return text.fault("says", message);
    conditions.push_back({"text", (is_there ? "\"" : "no \"") + says + "\"" + (box.empty() ? "" : " in " + box),
                          [says, box, is_there](const ObservedFrame& frame) {
                              return is_there ? observe_text(frame, says, box) : observe_no_text(frame, says, box);
                          }});
}

}  // namespace

void read_text_conditions(ScriptTable& table, ScriptFaults& faults, std::vector<FrameCondition>& conditions) {
    const ScriptValue* const value = table.take("text");
    if (value == nullptr) return;
    if (value->kind != ScriptValue::Kind::list) return read_text_condition(*value, faults, conditions);
    for (const ScriptValue& one : value->items) read_text_condition(one, faults, conditions);
}

}  // namespace tedavis::host_sim
