#include "cli/option_reader.h"

namespace mesher {

namespace po = boost::program_options;

Error usageError(std::string message, std::string remedy)
{
    return {ErrorCode::InvalidArgument, std::move(message), {}, {}, std::move(remedy)};
}

Result<po::variables_map> parseArguments(std::span<const std::string> arguments,
                                         po::options_description options)
{
    options.add_options()("input", po::value<std::vector<std::string>>()->composing());
    po::positional_options_description positional;
    positional.add("input", -1);
    po::variables_map found;
    try {
        const auto style = po::command_line_style::default_style & ~po::command_line_style::allow_guessing;
        const std::vector<std::string> texts(arguments.begin(), arguments.end());
        po::store(po::command_line_parser(texts).options(options).positional(positional).style(style).run(),
                  found);
        po::notify(found);
    } catch (const po::error& error) {
        return usageError(error.what());
    }
    return found;
}

void OptionReader::read(const char* option, std::string& target)
{
    if (found_.count(option) != 0) target = found_[option].as<std::string>();
}

std::optional<std::filesystem::path> OptionReader::path(const char* option) const
{
    if (found_.count(option) == 0) return std::nullopt;
    return std::filesystem::path(found_[option].as<std::string>());
}

std::vector<std::string> OptionReader::texts(const char* option) const
{
    using Texts = std::vector<std::string>;
    return found_.count(option) != 0 ? found_[option].as<Texts>() : Texts();
}

std::filesystem::path OptionReader::onlyInput(const std::string& what)
{
    const std::vector<std::string> inputs = texts("input");
    if (inputs.empty()) {
        fail(usageError("the " + what + " is missing"));
        return {};
    }
    if (inputs.size() > 1) fail(usageError("one " + what + " is expected, '" + inputs[1] + "' is too much"));
    if (inputs.front().empty()) fail(usageError("the name of the " + what + " is empty"));
    return inputs.front();
}

void OptionReader::fail(Error error)
{
    if (!error_) error_ = std::move(error);
}

}  // namespace mesher
