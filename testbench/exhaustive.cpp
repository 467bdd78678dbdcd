// Drives a Verilated core through ranges of operands, one vector a clock.
//
//   verilator --cc --exe --build -O3 --prefix Vcore --top-module NAME
//       -CFLAGS "-O2 -DOPERAND=in_cos -DOPERAND_BITS=18 -DLATENCY=6" NAME.v exhaustive.cpp
//
// Standard input: records of twelve bytes, little endian: uint32 in_n, int32 first operand code,
// uint32 count. The operand codes first, first+1, ... are fed, masked to OPERAND_BITS. in_n has
// to fit its port. Standard output: each result in order, as a little-endian uint32.
//
// Exit status: 0 at the end of the input; 2 the input ends within a record or cannot be read;
// 3 out_valid is not in_valid delayed by LATENCY clocks; 4 the output cannot be written.

#include <cerrno>
#include <csignal>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <cstring>

#include <poll.h>
#include <unistd.h>

#include "Vcore.h"
#include "verilated.h"

#if !defined(OPERAND) || !defined(OPERAND_BITS) || !defined(LATENCY)
#error "define OPERAND (the operand's port), OPERAND_BITS and LATENCY"
#endif

#ifndef DISABLE_WRITES // statements that make the enables of memories' write ports 0, for a core that has any
#define DISABLE_WRITES
#endif

namespace {

static_assert(OPERAND_BITS >= 1 && OPERAND_BITS <= 32, "an operand code is 32 bits in a record");
static_assert(LATENCY >= 1 && LATENCY <= 64, "the history of in_valid is one 64-bit word");

constexpr uint32_t OPERAND_MASK = 0xffffffffu >> (32 - OPERAND_BITS);
// The part of the history of in_valid that has not come out yet.
constexpr uint64_t PENDING = (uint64_t(1) << (LATENCY - 1)) - 1;
constexpr size_t RECORD = 12;
constexpr size_t INPUT_BYTES = RECORD * 4096;
constexpr size_t OUTPUT_BYTES = 64 * 1024;

uint8_t input[INPUT_BYTES];
size_t input_begin = 0;
size_t input_end = 0;

uint8_t output[OUTPUT_BYTES];
size_t output_end = 0;

Vcore* core = nullptr;
uint64_t history = 0;  // bit k: in_valid k clocks before the last one
uint64_t clocks = 0;

// Without the destructors: they would only cost time, and can do nothing more for the reader.
[[noreturn]] void leave(int status) {
    std::fflush(stderr);
    _exit(status);
}

uint32_t little_endian(const uint8_t* bytes) {
    return uint32_t(bytes[0]) | uint32_t(bytes[1]) << 8 | uint32_t(bytes[2]) << 16
           | uint32_t(bytes[3]) << 24;
}

void write_output() {
    size_t done = 0;
    while (done < output_end) {
        const ssize_t n = write(STDOUT_FILENO, output + done, output_end - done);
        if (n >= 0) {
            done += size_t(n);
        } else if (errno != EINTR) {
            std::fprintf(stderr, "exhaustive: cannot write: %s\n", std::strerror(errno));
            leave(4);
        }
    }
    output_end = 0;
}

[[noreturn]] void valid_is_wrong(bool expected) {
    // The results before this clock are right as far as out_valid goes: the reader gets them.
    write_output();
    std::fprintf(stderr, "exhaustive: clock %llu: out_valid is %d, expected %d (latency %d)\n",
                 static_cast<unsigned long long>(clocks), int(core->out_valid), int(expected),
                 LATENCY);
    leave(3);
}

// One clock with the inputs as they are set. The clock rises and falls again: a second evaluation
// is needed for the model to see the next rising edge.
inline void clock_core() {
    core->clk = 1;
    core->eval();
    core->clk = 0;
    core->eval();
    ++clocks;
}

inline void step(bool valid) {
    core->in_valid = valid;
    clock_core();
    history = history << 1 | uint64_t(valid);
    const bool expected = history >> (LATENCY - 1) & 1;
    if (__builtin_expect(bool(core->out_valid) != expected, 0)) valid_is_wrong(expected);
    if (expected) {
        const uint32_t result = core->out_spec;
        output[output_end] = uint8_t(result);
        output[output_end + 1] = uint8_t(result >> 8);
        output[output_end + 2] = uint8_t(result >> 16);
        output[output_end + 3] = uint8_t(result >> 24);
        output_end += 4;
        if (output_end == OUTPUT_BYTES) write_output();
    }
}

// Everything that was fed is given to the reader.
void drain() {
    while ((history & PENDING) != 0) step(false);
    write_output();
}

// The next record, or null at the end of the input.
const uint8_t* next_record() {
    while (input_end - input_begin < RECORD) {
        // The rest of a record goes to the front; the other records have been used.
        std::memmove(input, input + input_begin, input_end - input_begin);
        input_end -= input_begin;
        input_begin = 0;

        // A writer that waits for the results of one record before it sends the next gets them.
        pollfd ready = {STDIN_FILENO, POLLIN, 0};
        if (poll(&ready, 1, 0) == 0) drain();

        const ssize_t n = read(STDIN_FILENO, input + input_end, INPUT_BYTES - input_end);
        if (n > 0) {
            input_end += size_t(n);
        } else if (n == 0) {
            if (input_end == 0) return nullptr;
            drain();
            std::fprintf(stderr, "exhaustive: the input ends within a record (%zu of %zu bytes)\n",
                         input_end, RECORD);
            leave(2);
        } else if (errno != EINTR) {
            std::fprintf(stderr, "exhaustive: cannot read: %s\n", std::strerror(errno));
            leave(2);
        }
    }
    const uint8_t* record = input + input_begin;
    input_begin += RECORD;
    return record;
}

void reset() {
    core->clk = 0;
    core->rst = 1;
    core->ce = 1;
    core->in_valid = 0;
    core->in_n = 0;
    core->OPERAND = 0;
    DISABLE_WRITES
    core->eval();
    clock_core();
    core->rst = 0;
    for (int i = 0; i <= LATENCY; ++i) step(false);
}

}  // namespace

int main(int argc, char** argv) {
    // A reader that has gone away is seen by write().
    std::signal(SIGPIPE, SIG_IGN);
    Verilated::commandArgs(argc, argv);
    core = new Vcore;
    reset();
    while (const uint8_t* record = next_record()) {
        core->in_n = little_endian(record);
        uint32_t code = little_endian(record + 4);
        const uint32_t count = little_endian(record + 8);
        for (uint32_t i = 0; i < count; ++i) {
            core->OPERAND = code++ & OPERAND_MASK;
            step(true);
        }
    }
    // As many clocks as it takes to see that no more comes out than went in.
    for (int i = 0; i <= LATENCY; ++i) step(false);
    write_output();
    leave(0);
}
