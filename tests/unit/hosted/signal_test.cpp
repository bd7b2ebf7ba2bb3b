// SIGINT and SIGTERM end a run cleanly. Each test is a child process, whose standard output is read through a pipe.
#include "captured_run.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <csignal>
#include <sys/wait.h>
#include <unistd.h>

namespace ladder::hosted::test {
namespace {

struct Child {
  int exit = -1;
  std::string out;
};

/// Runs the program in a child, sends `signal` once it has printed a line, and waits for its end.
Child interrupt(std::vector<std::string> words, int signal) {
  int pipe_ends[2];
  EXPECT_EQ(pipe(pipe_ends), 0);
  std::fflush(nullptr);
  pid_t pid = fork();
  if (pid == 0) {
    close(pipe_ends[0]);
    std::FILE *out = fdopen(pipe_ends[1], "w");
    words.insert(words.begin(), "fake");
    std::vector<char *> argv;
    for (std::string &word : words)
      argv.push_back(word.data());
    int code = program_main(static_cast<int>(argv.size()), argv.data(), kFake, out, stderr);
    std::fclose(out);
    _exit(code);
  }
  close(pipe_ends[1]);
  Child child;
  char buffer[4096];
  bool sent = false;
  for (ssize_t size; (size = read(pipe_ends[0], buffer, sizeof buffer)) > 0;) {
    child.out.append(buffer, static_cast<std::size_t>(size));
    if (!sent)
      kill(pid, signal);
    sent = true;
  }
  close(pipe_ends[0]);
  int status = 0;
  EXPECT_EQ(waitpid(pid, &status, 0), pid);
  child.exit = WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
  return child;
}

TEST(Signals, InterruptEndsAWaitingProgramWithItsStatistics) {
  auto start = std::chrono::steady_clock::now();
  Child child = interrupt({"--scan-time", "60s", "--watch", "D2:f"}, SIGINT);
  EXPECT_EQ(child.exit, 0);
  EXPECT_THAT(child.out, testing::ContainsRegex("^scan 1, [0-9.]+ s: D2:f=1.5\nfake: 1 scan in [0-9.]+ s\n"));
  EXPECT_THAT(child.out, testing::EndsWith("  D2:f=1.5\n"));
  EXPECT_LT(std::chrono::steady_clock::now() - start, std::chrono::seconds(20));
}

TEST(Signals, TerminateEndsABusyProgram) {
  Child child = interrupt({"--free-running", "--watch", "D0", "--set", "X1=1"}, SIGTERM);
  EXPECT_EQ(child.exit, 0);
  EXPECT_THAT(child.out, testing::HasSubstr("\nfake: "));
}

TEST(Signals, FormerHandlersComeBack) {
  auto mine = [](int) {};
  auto former = std::signal(SIGINT, mine);
  EXPECT_EQ(run({"--virtual", "--scans", "1", "--quiet"}).exit, 0);
  EXPECT_EQ(std::signal(SIGINT, former), static_cast<void (*)(int)>(mine));
}

}  // namespace
}  // namespace ladder::hosted::test
