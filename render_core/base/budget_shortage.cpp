#include "render_core/base/budget_shortage.hpp"

namespace tedavis::base {
namespace {

constexpr std::string_view kBefore = "the budget line '", kHas = "' has ", kOf = " of ", kLeft = " bytes left and ",
                           kNeeded = " are needed", kFor = " for ", kRemedy = "; raise the line in the device file";

/// Reads what make_error() wrote, from front to back.
class SentenceReader {
public:
    explicit SentenceReader(std::string_view text) : rest_(text) {}

    [[nodiscard]] bool skip(std::string_view part) {
        if (rest_.substr(0, part.size()) != part) return false;
        rest_.remove_prefix(part.size());
        return true;
    }
    [[nodiscard]] bool name(FixedString<31>& value) {
        const std::size_t end = rest_.find('\'');
        if (end == std::string_view::npos) return false;
        value = FixedString<31>(rest_.substr(0, end));
        rest_.remove_prefix(end);
        return true;
    }
    [[nodiscard]] bool number(std::uint64_t& value) {
        constexpr std::size_t kMaxDigits = 19;
        std::size_t count = 0;
        value = 0;
        for (; count < rest_.size() && count < kMaxDigits && rest_[count] >= '0' && rest_[count] <= '9'; ++count)
            value = value * 10 + static_cast<std::uint64_t>(rest_[count] - '0');
        rest_.remove_prefix(count);
        return count > 0;
    }

private:
    std::string_view rest_;
};

}  // namespace

Error shortage_error(const BudgetShortage& shortage, std::string_view purpose) {
    Error error = make_error(kBefore, shortage.line.view(), kHas, digits(shortage.left).view(), kOf,
                             digits(shortage.capacity).view(), kLeft, digits(shortage.needed).view(), kNeeded);
    if (!purpose.empty()) {
        error.message.append(kFor);
        error.message.append(purpose);
    }
    error.message.append(kRemedy);
    return error;
}

Error shortage_error(const BudgetLine& line, std::uint64_t needed, std::string_view purpose) {
    return shortage_error({line.name, line.bytes - line.use.in_use, line.bytes, needed}, purpose);
}

Error shortage_error(std::string_view line, const ResourceUse& use, std::uint64_t needed, std::string_view purpose) {
    return shortage_error({FixedString<31>(line), use.capacity - use.in_use, use.capacity, needed}, purpose);
}

Error shortage_error(std::string_view line, const Arena& arena, std::string_view purpose) {
    return shortage_error(line, arena.use(), arena.refused_bytes(), purpose);
}

bool find_shortage(std::string_view message, BudgetShortage& shortage) {
    const std::size_t start = message.find(kBefore);
    if (start == std::string_view::npos) return false;
    SentenceReader reader(message.substr(start + kBefore.size()));
    return reader.name(shortage.line) && reader.skip(kHas) && reader.number(shortage.left) && reader.skip(kOf) &&
           reader.number(shortage.capacity) && reader.skip(kLeft) && reader.number(shortage.needed) && reader.skip(kNeeded) &&
           shortage.left <= shortage.capacity;
}

}  // namespace tedavis::base
