// Header: compiler/clang/parse/invoke.hpp. Test: tests/compiler/clang/faults_test.cpp,
// tests/compiler/clang/stubs/command_test.cpp. SPDX-License-Identifier: MIT
#include "compiler/clang/parse/invoke.hpp"

#include <clang/Frontend/CompilerInstance.h>
#include <clang/Frontend/FrontendAction.h>
#include <clang/Frontend/Utils.h>
#include <llvm/Support/VirtualFileSystem.h>

#include <cerrno>
#include <filesystem>
#include <map>
#include <regex>
#include <set>
#include <system_error>
#include <utility>

namespace director::scanning {

namespace {

/// Null if the command line is not understood, which is added to `faults`.
std::unique_ptr<clang::CompilerInvocation> run_driver(const Invocation& invocation, const Files& files,
                                                      clang::DiagnosticConsumer& faults) {
  // Clang finds its own headers, such as stddef.h, relative to its path: the first word must be a whole path, though it
  // is never executed.
  std::vector<const char*> words{DIRECTOR_CLANG_COMPILER};
  for (const std::string& word : invocation.arguments) words.push_back(word.c_str());
  words.insert(words.end(), {"-w", "-ferror-limit=0", "-fno-caret-diagnostics", invocation.file.c_str()});
  clang::CreateInvocationOptions options;
  options.Diags = clang::CompilerInstance::createDiagnostics(new clang::DiagnosticOptions, &faults, false);
  options.VFS = files;
  auto out = clang::createInvocation(words, options);
  if (out == nullptr || faults.getNumErrors() > 0) return nullptr;
  out->getFrontendOpts().DisableFree = false; // there are more files to come
  return out;
}

class OrdinaryFiles final : public llvm::vfs::ProxyFileSystem {
public:
  using ProxyFileSystem::ProxyFileSystem;
  llvm::ErrorOr<std::unique_ptr<llvm::vfs::File>> openFileForRead(const llvm::Twine& path) override {
    const auto status = this->status(path);
    const bool waits = status && (status->getType() == llvm::sys::fs::file_type::fifo_file ||
                                  status->getType() == llvm::sys::fs::file_type::socket_file);
    if (waits) return std::error_code(ENXIO, std::generic_category());
    return ProxyFileSystem::openFileForRead(path);
  }
};

} // namespace

Files ordinary_files() {
  return new OrdinaryFiles(llvm::IntrusiveRefCntPtr<llvm::vfs::FileSystem>(llvm::vfs::createPhysicalFileSystem()));
}

struct Frontend::Known {
  std::map<std::vector<std::string>, std::unique_ptr<clang::CompilerInvocation>> by_words;
};

Frontend::Frontend() : known_(std::make_unique<Known>()) {}
Frontend::~Frontend() = default;

bool Frontend::run(const Invocation& invocation, const Files& files, clang::FrontendAction& action,
                   clang::DiagnosticConsumer& faults) {
  files->setCurrentWorkingDirectory(invocation.directory);
  // The file name's ending decides between C and C++, header and source.
  std::vector<std::string> key = invocation.arguments;
  key.insert(key.end(), {invocation.directory, std::filesystem::path(invocation.file).extension().string()});
  auto at = known_->by_words.find(key);
  if (at == known_->by_words.end()) {
    auto fresh = run_driver(invocation, files, faults);
    if (fresh == nullptr) return false;
    at = known_->by_words.emplace(std::move(key), std::move(fresh)).first;
  }
  auto own = std::make_shared<clang::CompilerInvocation>(*at->second);
  clang::FrontendOptions& options = own->getFrontendOpts();
  options.Inputs = {clang::FrontendInputFile(invocation.file, options.Inputs.front().getKind())};
  clang::CompilerInstance compiler;
  compiler.setInvocation(std::move(own));
  compiler.setFileManager(new clang::FileManager(clang::FileSystemOptions{}, files));
  compiler.createDiagnostics(&faults, false);
  compiler.createSourceManager(compiler.getFileManager());
  return compiler.ExecuteAction(action);
}

bool drop_unknown(std::vector<std::string>& arguments, const std::vector<std::string>& errors) {
  static const std::regex unknown_word{
      "(?:unknown argument|unsupported option|unsupported argument).*?'([^']*)'(?:.*option '([^']*)')?.*"};
  static const std::regex unknown_processor{"unknown target CPU '([^']*)'"};
  std::set<std::string> unknown;
  for (const std::string& error : errors) {
    std::smatch match;
    if (std::regex_match(error, match, unknown_word)) {
      unknown.insert(match[2].matched ? match[2].str() + match[1].str() : match[1].str());
    } else if (std::regex_match(error, match, unknown_processor)) {
      for (const char* option : {"-march=", "-mcpu=", "-mtune="}) unknown.insert(option + match[1].str());
    }
  }
  return std::erase_if(arguments, [&](const std::string& word) { return unknown.count(word) > 0; }) > 0;
}

} // namespace director::scanning
