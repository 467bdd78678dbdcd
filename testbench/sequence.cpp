// Drives a Verilated core that takes the lights of a sample in sequence, one clock's lights a clock without a pause, or one without lights,
// whose samples are a clock each.
//
// A header, written by brdfgen for each core, defines LATENCY (clocks from a sample's last lights to the sample), INPUTS (how many ports
// carry numbers) and the functions
//   void present(Vcore&, const uint32_t* codes)   sets the input ports, masked to their widths, and makes write enables 0
//   void end(Vcore&, bool last)   says whether the sample ends with this clock, where there is a port for it
//   void sample(const Vcore&, uint32_t* codes)   reads the three output ports
//
// Standard input, in 32-bit words of the machine's order: for each clock whether the sample ends with it, then the codes of the inputs.
// Standard output: the three codes of each sample in order, in the same words.
//
// Exit status: 0 at the end of the input; 2 the input ends within a clock's words; 3 out_valid is not that of the samples' ends LATENCY
// clocks later; 4 the output cannot be written.

#include <cstdint>
#include <cstdio>
#include <cstdlib>

#include "Vcore.h"
#include "verilated.h"

#include "core.h"

namespace {

static_assert(LATENCY >= 1 && LATENCY <= 64, "the history of the samples' ends is one 64-bit word");

Vcore* core = nullptr;
uint64_t history = 0;  // bit k: a sample ended k clocks before the last one
uint64_t clocks = 0;

// Without the destructors: they would only cost time.
[[noreturn]] void leave(int status) {
    std::fflush(stdout);
    std::fflush(stderr);
    std::_Exit(status);
}

void step(bool valid, bool last) {
    core->in_valid = valid;
    end(*core, last);
    core->clk = 1;
    core->eval();
    core->clk = 0;
    core->eval();
    ++clocks;
    history = history << 1 | uint64_t(valid && last);
    const bool expected = history >> (LATENCY - 1) & 1;
    if (bool(core->out_valid) != expected) {
        std::fprintf(stderr, "sequence: clock %llu: out_valid is %d, expected %d (latency %d)\n", static_cast<unsigned long long>(clocks),
                     int(core->out_valid), int(expected), LATENCY);
        leave(3);
    }
    if (expected) {
        uint32_t codes[3];
        sample(*core, codes);
        if (std::fwrite(codes, sizeof codes, 1, stdout) != 1) leave(4);
    }
}

void reset() {
    const uint32_t zero[INPUTS] = {};
    core->clk = 0;
    core->rst = 1;
    core->ce = 1;
    present(*core, zero);
    step(false, false);
    core->rst = 0;
    for (int i = 0; i <= LATENCY; ++i) step(false, false);
}

}  // namespace

int main(int argc, char** argv) {
    Verilated::commandArgs(argc, argv);
    core = new Vcore;
    reset();
    uint32_t words[1 + INPUTS];
    size_t read;
    while ((read = std::fread(words, sizeof(uint32_t), 1 + INPUTS, stdin)) == 1 + INPUTS) {
        present(*core, words + 1);
        step(true, words[0] != 0);
    }
    // As many clocks as it takes to see that no more comes out than went in.
    for (int i = 0; i <= LATENCY; ++i) step(false, false);
    if (read != 0) std::fprintf(stderr, "sequence: the input ends within the words of a clock\n");
    leave(read == 0 ? 0 : 2);
}
