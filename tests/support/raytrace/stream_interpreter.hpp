/// What a token stream comes to, by plain recursion: each call alone, the first one first, until no call that has its arguments
/// is left. No blocks, no rounds, no batches. The oracle of raytrace/stream.
#pragma once

#include <vector>

#include "render_core/raytrace/stream/token_writer.hpp"

namespace tedavis::test_support {

class StreamInterpreter {
public:
    explicit StreamInterpreter(const raytrace::TaskNetwork& network) : network_(network) {}

    std::vector<raytrace::Token> evaluate(const std::vector<raytrace::Token>& program) {
        std::vector<raytrace::Token> stack;
        for (const raytrace::Token& token : program) take(stack, token);
        return stack;
    }
    /// The most tokens that lay on the stack at once.
    std::size_t most_tokens() const { return most_tokens_; }

private:
    using Tokens = std::vector<raytrace::Token>;

    void take(Tokens& stack, const raytrace::Token& token) {
        const raytrace::TaskId id = raytrace::called_task(token.word);
        const std::size_t count = token.is_call ? raytrace::call_count(token.word) : 0;
        const std::size_t words = token.is_call && id < network_.size() ? count * network_.task(id).arguments : 0;
        if (!token.is_call || id >= network_.size() || !ends_with_literals(stack, words)) {
            stack.push_back(token);
            most_tokens_ = std::max(most_tokens_, stack.size());
            return;
        }
        std::vector<std::uint32_t> arguments;
        for (std::size_t n = stack.size() - words; n < stack.size(); ++n) arguments.push_back(stack[n].word);
        stack.resize(stack.size() - words);
        for (std::size_t n = 0; n < count; ++n)
            for (const raytrace::Token& given : run_one(id, arguments.data() + n * network_.task(id).arguments))
                take(stack, given);
    }

    static bool ends_with_literals(const Tokens& stack, std::size_t count) {
        if (stack.size() < count) return false;
        for (std::size_t n = stack.size() - count; n < stack.size(); ++n)
            if (stack[n].is_call) return false;
        return true;
    }

    Tokens run_one(raytrace::TaskId id, const std::uint32_t* arguments) {
        raytrace::TokenWriter out(network_, {words_.data(), words_.size()}, {places_.data(), places_.size()});
        const raytrace::Task& task = network_.task(id);
        const std::uint32_t border = 1;
        raytrace::WrittenRun run;
        out.begin({&border, 1}, &run, task.most_outputs);
        task.run(task.context, {arguments, 1, task.arguments, id, task.next}, out);
        out.finish();
        TEDAVIS_CHECK(out.fault() == raytrace::WriterFault::none);
        Tokens given;
        for (std::uint32_t n = 0; n < run.words; ++n) given.push_back({words_[n], false});
        for (std::uint32_t n = 0; n < run.calls; ++n) given[places_[n]].is_call = true;
        return given;
    }

    const raytrace::TaskNetwork& network_;
    std::vector<std::uint32_t> words_ = std::vector<std::uint32_t>(raytrace::kMaxOutputWords);
    std::vector<std::uint16_t> places_ = std::vector<std::uint16_t>(raytrace::kMaxOutputWords);
    std::size_t most_tokens_ = 0;
};

}  // namespace tedavis::test_support
