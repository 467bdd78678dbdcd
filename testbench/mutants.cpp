// Runs golden vectors through a Verilated core with an input `mutant` that chooses what is wrong in it; 0 is the core as it should be.
//
// A header, written by brdfgen for each core, defines LATENCY, INPUTS and OUTPUTS (how many ports carry numbers), INPUT_BITS (an array
// of their widths), RECENT (how many of the last inputs are told), WRITE_WORDS (of a write: the write port's number, the address, and the
// memory's word, lowest 32 bits first), and the functions
//   void present(Vcore&, const uint32_t* codes)   sets the input ports, masked to their widths, and makes write enables 0
//   bool shows(const Vcore&, const uint32_t* codes)   compares the output ports
//   bool same(const Vcore&, const Vcore&)   compares two cores' output ports
//   void write(Vcore&, const uint32_t* write)   sets the write port of a memory
//
// Standard input, in 32-bit words of the machine's order: a task, then what it needs.
//   0, first mutant, mutants, vectors, then for each vector its inputs, its outputs, idle, stall, how many writes come before it, when
//      the core is empty, and these: writes for each of the mutants from the first on the number of the vector (from 1) at which it is found out, 0xffffffff if by the reset, and 0 if it is not found out.
//   1, mutant, low and high word of the first place, low and high word of how many: runs these of all inputs, the ports' bits side by
//      side, first port most significant, one a clock, and writes the place of the first that tells the mutant from the core, as two
//      words, 0xffffffff twice if none does.
//   2, mutant, clocks: random inputs, ce, in_valid and rst; writes the clock at which the mutant differs, two words as above, and the
//      last RECENT inputs that came with ce, in their order (zeros in front of them if there were fewer).
//
// Exit status: 0, or 2 if the input ends too early.

#include <cstdint>
#include <cstdio>
#include <memory>
#include <vector>

#include "Vcore.h"
#include "verilated.h"

#include "core.h"

namespace {

constexpr uint32_t BY_RESET = 0xffffffffu;

struct Vector {
    uint32_t inputs[INPUTS];
    uint32_t outputs[OUTPUTS];
    uint32_t idle;
    uint32_t stall;
    std::vector<uint32_t> writes;
};

bool read_words(uint32_t* words, size_t count) {
    return std::fread(words, sizeof(uint32_t), count, stdin) == count;
}

void write_words(const uint32_t* words, size_t count) {
    std::fwrite(words, sizeof(uint32_t), count, stdout);
    std::fflush(stdout);
}

void clock_core(Vcore& core) {
    core.clk = 1;
    core.eval();
    core.clk = 0;
    core.eval();
}

// A core at rest.
std::unique_ptr<Vcore> powered(uint32_t mutant) {
    auto core = std::make_unique<Vcore>();
    const uint32_t zero[INPUTS] = {};
    core->clk = 0;
    core->rst = 0;
    core->ce = 0;
    core->in_valid = 0;
    core->mutant = mutant;
    present(*core, zero);
    core->eval();
    return core;
}

// A core with a delay line of what it should answer: the number of a vector, or 0 for nothing.
class Bench {
  public:
    Bench(uint32_t mutant, const std::vector<Vector>& vectors)
        : core_(powered(mutant)), vectors_(vectors), due_(LATENCY, 0) {}

    // The vector, from 1, at which something is wrong; 0 if nothing is.
    uint32_t run() {
        if (!reset_is_right()) return BY_RESET;
        for (uint32_t number = 1; number <= vectors_.size(); ++number) {
            const Vector& vector = vectors_[number - 1];
            uint32_t garbage[INPUTS];
            for (int port = 0; port < INPUTS; ++port) garbage[port] = ~vector.inputs[port];
            if (!vector.writes.empty() && !loads(vector.writes)) return number;
            for (uint32_t i = 0; i < vector.idle; ++i)
                if (!step(garbage, true, false, 0)) return number;
            for (uint32_t i = 0; i < vector.stall; ++i)
                if (!step(garbage, false, true, 0)) return number;
            if (!step(vector.inputs, true, true, number)) return number;
        }
        return runs_empty() ? 0 : uint32_t(vectors_.size());
    }

  private:
    bool runs_empty() {
        const uint32_t zero[INPUTS] = {};
        for (int i = 0; i < LATENCY + 2; ++i)
            if (!step(zero, true, false, 0)) return false;
        return true;
    }

    // Writes into the memories, whatever ce and rst are.
    bool loads(const std::vector<uint32_t>& writes) {
        const uint32_t zero[INPUTS] = {};
        if (!runs_empty()) return false;
        for (size_t i = 0; i < writes.size() / WRITE_WORDS; ++i) {
            set(zero, i % 2 == 0, false);
            core_->rst = i % 4 < 2;
            write(*core_, &writes[i * WRITE_WORDS]);
            clock_core(*core_);
        }
        core_->rst = 0;
        return true;
    }

    // Filled and reset, with the clock enabled and then without: nothing may come out.
    bool reset_is_right() {
        const uint32_t zero[INPUTS] = {};
        for (int ce = 1; ce >= 0; --ce) {
            for (size_t i = 0; i < vectors_.size() && i < LATENCY + 2; ++i) {
                set(vectors_[i].inputs, true, true);
                clock_core(*core_);
            }
            // An input that is presented at the same time does not count either; a core of one stage shows only here that it was reset.
            set(zero, ce != 0, true);
            core_->rst = 1;
            clock_core(*core_);
            core_->rst = 0;
            if (core_->out_valid) return false;
            for (int i = 0; i < LATENCY; ++i)
                if (!step(zero, true, false, 0)) return false;
        }
        return true;
    }

    void set(const uint32_t* inputs, bool ce, bool valid) {
        present(*core_, inputs);
        core_->ce = ce;
        core_->in_valid = valid;
    }

    bool step(const uint32_t* inputs, bool ce, bool valid, uint32_t number) {
        set(inputs, ce, valid);
        clock_core(*core_);
        if (ce) {
            due_.insert(due_.begin(), number);
            due_.pop_back();
        }
        const uint32_t due = due_.back();
        if (due == 0) return !core_->out_valid;
        return core_->out_valid && shows(*core_, vectors_[due - 1].outputs);
    }

    std::unique_ptr<Vcore> core_;
    const std::vector<Vector>& vectors_;
    std::vector<uint32_t> due_;
};

// The inputs at a place among all.
void at_place(uint64_t place, uint32_t* inputs) {
    for (int port = INPUTS - 1; port >= 0; --port) {
        inputs[port] = uint32_t(place);
        place >>= INPUT_BITS[port];
    }
}

void every(uint32_t mutant, uint64_t first, uint64_t count) {
    auto right = powered(0), wrong = powered(mutant);
    uint64_t found = ~uint64_t(0);
    for (uint64_t i = 0; i < count + LATENCY; ++i) {
        uint32_t inputs[INPUTS];
        at_place(first + (i < count ? i : count - 1), inputs);
        for (Vcore* core : {right.get(), wrong.get()}) {
            present(*core, inputs);
            core->ce = 1;
            core->in_valid = i < count;
            clock_core(*core);
        }
        if (right->out_valid != wrong->out_valid || (right->out_valid && !same(*right, *wrong))) {
            found = first + (i < LATENCY ? 0 : i + 1 - LATENCY);
            break;
        }
    }
    const uint32_t words[2] = {uint32_t(found), uint32_t(found >> 32)};
    write_words(words, 2);
}

void at_random(uint32_t mutant, uint32_t clocks) {
    auto right = powered(0), wrong = powered(mutant);
    uint64_t state = 0x9e3779b97f4a7c15u, found = ~uint64_t(0);
    std::vector<uint32_t> recent(RECENT * INPUTS, 0);
    const auto draw = [&state] {
        state ^= state << 13;
        state ^= state >> 7;
        state ^= state << 17;
        return uint32_t(state >> 16);
    };
    for (uint32_t i = 0; i < clocks; ++i) {
        uint32_t inputs[INPUTS];
        for (int port = 0; port < INPUTS; ++port) inputs[port] = draw();
        const uint32_t control = draw();
        if (control % 4 != 0) {
            recent.erase(recent.begin(), recent.begin() + INPUTS);
            recent.insert(recent.end(), inputs, inputs + INPUTS);
        }
        for (Vcore* core : {right.get(), wrong.get()}) {
            present(*core, inputs);
            core->ce = control % 4 != 0;
            core->in_valid = control / 4 % 4 != 0;
            core->rst = control / 16 % 64 == 0;
            clock_core(*core);
        }
        if (right->out_valid != wrong->out_valid || (right->out_valid && !same(*right, *wrong))) {
            found = i;
            break;
        }
    }
    const uint32_t words[2] = {uint32_t(found), uint32_t(found >> 32)};
    write_words(words, 2);
    write_words(recent.data(), recent.size());
}

}  // namespace

int main(int argc, char** argv) {
    Verilated::commandArgs(argc, argv);
    uint32_t task;
    while (read_words(&task, 1)) {
        uint32_t words[5];
        if (task == 0) {
            if (!read_words(words, 3)) return 2;
            std::vector<Vector> vectors(words[2]);
            for (Vector& vector : vectors) {
                uint32_t writes;
                if (!read_words(vector.inputs, INPUTS) || !read_words(vector.outputs, OUTPUTS)
                    || !read_words(&vector.idle, 1) || !read_words(&vector.stall, 1) || !read_words(&writes, 1))
                    return 2;
                vector.writes.resize(size_t(writes) * WRITE_WORDS);
                if (!read_words(vector.writes.data(), vector.writes.size())) return 2;
            }
            for (uint32_t mutant = 0; mutant < words[1]; ++mutant) {
                const uint32_t found = Bench(words[0] + mutant, vectors).run();
                write_words(&found, 1);
            }
        } else if (task == 1) {
            if (!read_words(words, 5)) return 2;
            every(words[0], words[1] | uint64_t(words[2]) << 32, words[3] | uint64_t(words[4]) << 32);
        } else {
            if (!read_words(words, 2)) return 2;
            at_random(words[0], words[1]);
        }
    }
    return 0;
}
