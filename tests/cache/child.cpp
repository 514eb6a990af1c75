#include <sys/wait.h>
#include <unistd.h>

#include <cstdlib>

#include "tests/cache/rows.h"

namespace anteroom::test {

int fork(const std::function<int()>& body) {
  const int child = ::fork();
  if (child == 0) _exit(body());
  return child;
}

int join(int child) {
  int status = 0;
  if (waitpid(child, &status, 0) != child) return -1;
  return WIFEXITED(status) ? WEXITSTATUS(status) : -WTERMSIG(status);
}

Output runProgram(const std::string& program, const std::vector<std::string>& environment,
                  std::vector<std::string> arguments) {
  const Folder folder;
  const std::string out = folder.path / "out", err = folder.path / "err";
  const int child = fork([&] {
    for (const std::string& entry : environment) {
      const size_t equals = entry.find('=');
      if (equals == std::string::npos)
        unsetenv(entry.c_str());
      else
        setenv(entry.substr(0, equals).c_str(), entry.c_str() + equals + 1, 1);
    }
    if (!freopen(out.c_str(), "w", stdout) || !freopen(err.c_str(), "w", stderr)) return 126;
    arguments.insert(arguments.begin(), program);
    std::vector<char*> pointers;
    for (std::string& argument : arguments) pointers.push_back(argument.data());
    pointers.push_back(nullptr);
    execv(program.c_str(), pointers.data());
    return 127;
  });
  const int status = join(child);
  return {status, contents(out), contents(err)};
}

}  // namespace anteroom::test
