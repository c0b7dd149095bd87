// Header: compiler/clang/parse/parse.hpp. Test: tests/compiler/clang.
// SPDX-License-Identifier: MIT
#include "compiler/clang/parse/parse.hpp"

#include "compiler/clang/parse/invoke.hpp"
#include "compiler/clang/parse/own_headers.hpp"

#include <clang/Basic/Diagnostic.h>
#include <clang/Frontend/CompilerInstance.h>
#include <clang/Frontend/FrontendAction.h>
#include <clang/Sema/Sema.h>
#include <clang/Sema/SemaConsumer.h>
#include <llvm/Support/VirtualFileSystem.h>

#include <map>
#include <set>
#include <system_error>
#include <utility>

namespace director::scanning {

namespace {

std::string absolute(llvm::StringRef path, const std::string& directory) {
  const bool is_absolute = path.starts_with("/");
  return is_absolute ? path.str() : directory + "/" + path.str();
}

class Errors final : public clang::DiagnosticConsumer {
public:
  Errors(const Unit& unit, std::vector<Fault>& faults) : unit_(unit), faults_(faults) {}

  void HandleDiagnostic(clang::DiagnosticsEngine::Level level, const clang::Diagnostic& info) override {
    clang::DiagnosticConsumer::HandleDiagnostic(level, info);
    if (level < clang::DiagnosticsEngine::Error) return;
    llvm::SmallString<256> text;
    info.FormatDiagnostic(text);
    Fault fault{text.str().str(), {}};
    if (info.hasSourceManager() && info.getLocation().isValid()) {
      const clang::PresumedLoc place = info.getSourceManager().getPresumedLoc(info.getLocation());
      if (place.isValid()) {
        fault.file = absolute(place.getFilename(), unit_.directory);
        fault.line = place.getLine();
        fault.column = place.getColumn();
      }
    }
    faults_.push_back(std::move(fault));
  }

private:
  const Unit& unit_;
  std::vector<Fault>& faults_;
};

/// Notes the paths at which nothing was found, such as a header in a folder before the one where it is.
class NotingFiles final : public llvm::vfs::ProxyFileSystem {
public:
  NotingFiles(llvm::IntrusiveRefCntPtr<llvm::vfs::FileSystem> files, const std::string& directory)
      : ProxyFileSystem(std::move(files)),
        directory_(directory) {}

  llvm::ErrorOr<llvm::vfs::Status> status(const llvm::Twine& path) override {
    auto out = ProxyFileSystem::status(path);
    note(path, out.getError());
    return out;
  }
  llvm::ErrorOr<std::unique_ptr<llvm::vfs::File>> openFileForRead(const llvm::Twine& path) override {
    auto out = ProxyFileSystem::openFileForRead(path);
    note(path, out.getError());
    return out;
  }

  std::set<std::string> absent;

private:
  void note(const llvm::Twine& path, std::error_code fault) {
    if (fault == std::errc::no_such_file_or_directory) absent.insert(absolute(path.str(), directory_));
  }

  const std::string& directory_;
};

struct Callbacks {
  const std::function<void(clang::ASTContext&)>& look;
  const std::function<void(clang::Sema&)>& complete;
};

class Consumer final : public clang::SemaConsumer {
public:
  Consumer(const Unit& unit, Reading& reading, const Callbacks& callbacks)
      : unit_(unit),
        reading_(reading),
        callbacks_(callbacks) {}

  void InitializeSema(clang::Sema& sema) override { sema_ = &sema; }
  void ForgetSema() override { sema_ = nullptr; }

  void HandleTranslationUnit(clang::ASTContext& context) override {
    const clang::SourceManager& sources = context.getSourceManager();
    std::vector<clang::Decl*> own;
    for (clang::Decl* decl : context.getTranslationUnitDecl()->decls()) {
      if (!sources.isInSystemHeader(decl->getLocation())) own.push_back(decl);
    }
    context.setTraversalScope(own);
    if (callbacks_.complete && sema_ != nullptr) callbacks_.complete(*sema_);
    callbacks_.look(context);
    note_files(sources);
  }

  bool shouldSkipFunctionBody(clang::Decl* decl) override {
    return !unit_.is_deep && decl->getASTContext().getSourceManager().isInSystemHeader(decl->getLocation());
  }

private:
  void note_files(const clang::SourceManager& sources) {
    std::map<std::string, bool> files;
    for (unsigned i = 0; i < sources.local_sloc_entry_size(); ++i) {
      const clang::SrcMgr::SLocEntry& entry = sources.getLocalSLocEntry(i);
      if (!entry.isFile()) continue;
      const clang::SrcMgr::FileInfo& info = entry.getFile();
      const clang::OptionalFileEntryRef file = info.getContentCache().OrigEntry;
      if (!file) continue;
      const auto begin = clang::SourceLocation::getFromRawEncoding(entry.getOffset());
      files.emplace(absolute(file->getName(), unit_.directory),
                    clang::SrcMgr::isSystem(info.getFileCharacteristic()) &&
                        sources.isInSystemHeader(sources.getLocForEndOfFile(sources.getFileID(begin))));
    }
    for (const auto& [path, system] : files) reading_.files.push_back({path, system});
  }

  const Unit& unit_;
  Reading& reading_;
  const Callbacks& callbacks_;
  clang::Sema* sema_ = nullptr;
};

class Action final : public clang::ASTFrontendAction {
public:
  Action(const Unit& unit, Reading& reading, const Callbacks& callbacks)
      : unit_(unit),
        reading_(reading),
        callbacks_(callbacks) {}

  bool BeginInvocation(clang::CompilerInstance& compiler) override {
    compiler.getFrontendOpts().SkipFunctionBodies = true;
    compiler.getLangOpts().SpellChecking = unit_.corrects_names;
    return true;
  }
  std::unique_ptr<clang::ASTConsumer> CreateASTConsumer(clang::CompilerInstance& compiler, llvm::StringRef) override {
    own_headers(compiler.getPreprocessor());
    return std::make_unique<Consumer>(unit_, reading_, callbacks_);
  }

private:
  const Unit& unit_;
  Reading& reading_;
  const Callbacks& callbacks_;
};

/// CMake marks what a precompiled header includes as headers of the system; they are the user's.
constexpr llvm::StringRef marks[] = {"#pragma GCC system_header", "#pragma clang system_header"};

using Memory = llvm::IntrusiveRefCntPtr<llvm::vfs::InMemoryFileSystem>;

/// Adds files that are included before the source without that mark: `-include FILE`, also behind `-Xclang`.
void add_unmarked(const Unit& unit, const std::vector<std::string>& arguments, Memory& to) {
  bool included = false;
  for (const std::string& word : arguments) {
    if (word == "-Xclang") continue;
    if (!std::exchange(included, word == "-include")) continue;
    const std::string path = absolute(word, unit.directory);
    const auto file = llvm::MemoryBuffer::getFile(path);
    if (!file) continue;
    std::string text = (*file)->getBuffer().str();
    for (const llvm::StringRef mark : marks) {
      const std::size_t at = text.find(mark.str());
      if (at != std::string::npos) text.replace(at, mark.size(), mark.size(), ' ');
    }
    if (text != (*file)->getBuffer()) to->addFile(path, 0, llvm::MemoryBuffer::getMemBufferCopy(text));
  }
}

Reading parse_once(const Unit& unit, const std::vector<std::string>& arguments, const Callbacks& callbacks) {
  Reading reading;
  llvm::IntrusiveRefCntPtr<llvm::vfs::OverlayFileSystem> disk(new llvm::vfs::OverlayFileSystem(ordinary_files()));
  Memory memory(new llvm::vfs::InMemoryFileSystem);
  if (!unit.text.empty()) memory->addFile(unit.file, 0, llvm::MemoryBuffer::getMemBufferCopy(unit.text));
  add_unmarked(unit, arguments, memory);
  disk->pushOverlay(memory);
  Errors errors(unit, reading.errors);
  Action action(unit, reading, callbacks);
  const llvm::IntrusiveRefCntPtr<NotingFiles> noting(new NotingFiles(disk, unit.directory));
  Frontend().run({unit.file, unit.directory, arguments}, noting, action, errors);
  reading.absent.assign(noting->absent.begin(), noting->absent.end());
  return reading;
}

} // namespace

Reading parse(const Unit& unit, const std::function<void(clang::ASTContext&)>& look,
              const std::function<void(clang::Sema&)>& complete) {
  const Callbacks callbacks{look, complete};
  std::vector<std::string> arguments = unit.arguments;
  for (;;) {
    Reading reading = parse_once(unit, arguments, callbacks);
    std::vector<std::string> of_command_line;
    for (const Fault& fault : reading.errors) {
      if (fault.file.empty()) of_command_line.push_back(fault.message);
    }
    if (!drop_unknown(arguments, of_command_line)) return reading;
  }
}

} // namespace director::scanning
