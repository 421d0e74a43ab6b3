#include "studies/program/exit_code.h"

#include <filesystem>
#include <iostream>

#include "studies/input/input_error.h"

namespace zona::studies {

int with_messages(const std::function<int()>& command) {
  try {
    const int code = command();
    std::cout.flush();
    return code;
  } catch (const InputError& error) {
    std::cerr << error.what() << '\n';
    const std::size_t count = error.problems().size();
    if (count > 1) std::cerr << count << " problems\n";
    return exit_bad_input;
  } catch (const std::filesystem::filesystem_error& error) {  // before a run begins
    std::cerr << printable(error.path1().string(), 400) << ": cannot be used ("
              << error.code().message() << ")\n";
    return exit_bad_input;
  } catch (const std::exception& error) {
    std::cerr << "zona: " << error.what() << '\n';
    return exit_failed;
  }
}

}  // namespace zona::studies
