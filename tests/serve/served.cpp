#include "tests/serve/served.h"

#include <fcntl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <csignal>
#include <stdexcept>
#include <utility>

#include "tests/places.h"

namespace knuckle::test {

Served::Served(const std::string& scene, const std::vector<std::string>& options)
{
    std::vector<std::string> words{programPath(), "--device", "software", "serve", scene, "--port", "0"};
    words.insert(words.end(), options.begin(), options.end());
    std::vector<char*> arguments;
    for (std::string& word : words) arguments.push_back(word.data());
    arguments.push_back(nullptr);
    std::array<int, 2> ends{};
    if (pipe2(ends.data(), O_CLOEXEC) != 0) throw std::runtime_error("no pipe");
    process_ = fork();
    if (process_ == 0) {
        dup2(ends[1], STDOUT_FILENO);
        dup2(ends[1], STDERR_FILENO);
        execv(arguments[0], arguments.data());
        _exit(126);
    }
    close(ends[1]);
    output_ = ends[0];
    while (unread_.find('\n') == std::string::npos && read()) {
    }
    const size_t start = unread_.find("http://"), end = unread_.find("; Ctrl-C");
    if (start == std::string::npos || end == std::string::npos)
        throw std::runtime_error("it does not start: " + unread_);
    address_ = unread_.substr(start, end - start);
    unread_.clear();
}

Served::~Served()
{
    if (process_ > 0) end();
    close(output_);
}

bool Served::read()
{
    std::array<char, 4096> bytes{};
    const ssize_t count = ::read(output_, bytes.data(), bytes.size());
    if (count > 0) unread_.append(bytes.data(), static_cast<size_t>(count));
    return count > 0;
}

std::string Served::end()
{
    kill(process_, SIGINT);
    while (read()) {
    }
    waitpid(std::exchange(process_, -1), nullptr, 0);
    return unread_;
}

}  // namespace knuckle::test
