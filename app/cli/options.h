// What the commands of suffuse-cli share: exit codes, parsing, the picture's size, output.
#pragma once

#include "model/painting/painting.h"
#include "model/result.h"
#include "render/image_io/image_io.h"
#include "render/renderer.h"

#include <QCommandLineParser>
#include <QHash>
#include <QJsonObject>
#include <QString>
#include <QStringList>

#include <atomic>
#include <optional>

namespace suffuse::cli {

enum ExitCode { Done = 0, Failed = 1, WrongUsage = 2 };

/// `arguments` as QCoreApplication::arguments(): program, command, then the command's own. Each returns an ExitCode.
int fitCommand(const QStringList &arguments);
int refitCommand(const QStringList &arguments);
int renderCommand(const QStringList &arguments);
int farmCommand(const QStringList &arguments);
int extensionCommand(const QStringList &arguments);
int infoCommand(const QStringList &arguments);
int convertCommand(const QStringList &arguments);
int probeCommand(const QStringList &arguments);
int verifyCommand(const QStringList &arguments);
int diffCommand(const QStringList &arguments);
int timelapseCommand(const QStringList &arguments);
int thumbnailCommand(const QStringList &arguments);
int recoverCommand(const QStringList &arguments);

/// The parser of one command.
class CommandLine {
public:
    /// `positional`: the names of its arguments, one by one, e.g. {"IN", "OUT"}; --help says what each is.
    CommandLine(const QString &command, const QString &description, const QStringList &positional);

    /// Adds an option; without `value` (its name in the help) it is a switch.
    void add(const QStringList &names, const QString &description, const QString &value = {});
    /// Lets an option be given several times.
    void allowRepeated(const QString &option) { m_repeatable.append(option); }
    /// Lets the first argument be given several times.
    void allowSeveral() { m_isSeveral = true; }
    /// Parses. An exit code where the command ends here: help, unknown options, one given twice, a wrong number of
    /// arguments. Negative numbers are arguments, not options. `required` = -1: all of the positional ones.
    std::optional<int> parse(const QStringList &arguments, int required = -1);

    /// False too for an option that the command does not have.
    bool isSet(const QString &option) const { return m_options.contains(option) && m_parser.isSet(option); }
    QString value(const QString &option) const { return m_parser.value(option); }
    /// Of an option that may be given several times.
    QStringList values(const QString &option) const { return m_parser.values(option); }
    /// The positional argument i, or empty; of the first one the first.
    QString argument(int i) const { return m_positional.value(i > 0 && m_isSeveral ? i + more() : i); }
    /// All of the first one, where it may be given several times.
    QStringList several() const { return m_positional.first(more() + 1); }

private:
    int more() const { return int(m_positional.size() - m_syntax.size()); }
    QStringList withProtectedNumbers(const QStringList &arguments) const;
    QString help(int required) const;
    /// An option that is given more than once, with dashes; or empty.
    QString repeatedOption() const;

    QString m_command;
    QStringList m_syntax; ///< the names of the positional arguments
    QCommandLineParser m_parser;
    QHash<QString, QString> m_options; ///< each name, and the first one of its option
    QStringList m_valueOptions;        ///< with dashes
    QStringList m_repeatable;
    QStringList m_positional;
    bool m_isSeveral = false;
};

/// The painting of a file, or of the standard input for "-". What a foreign file has and a painting cannot have is left
/// out with a warning. `resolution` receives DocumentExtras::resolution.
Result<Painting> paintingOf(const QString &path, double *resolution = nullptr);

/// Whether what is written to `out` takes the place of `in`, by whatever names and links.
bool isSameFile(const QString &in, const QString &out);
/// What to say then.
QString inputWouldBeLost(const QString &out);

/// Why a picture cannot be written to OUT, found before it is drawn; empty: it can, or OUT is "-".
QString problemOfPictureFile(const QString &out);

/// Prints "suffuse-cli: MESSAGE" on stderr.
void warn(const QString &message);
/// The same, and returns the code.
int fail(const QString &message, ExitCode code = Failed);
/// A usage error: the message and where help is.
int failUsage(const QString &command, const QString &message);
/// Writes text to stdout; Failed where that fails (a full disk). Where nobody reads on (`| head`), the process ends
/// without a word, by SIGPIPE, as others do.
int print(const QString &text);
/// The same with bytes.
int printBytes(const QByteArray &bytes);
/// The object on several lines, keys in alphabetical order.
int printJson(const QJsonObject &object);

/// A finite number, whole text, C locale.
std::optional<double> toNumber(const QString &text);

/// What part of the painting is drawn, how large and when.
struct PictureOptions {
    Rect area;
    int width = 0;
    int height = 0;
    Microseconds time = 0;
};
/// What limits a picture: its pixels, which are all in memory, or in tiles its sides.
enum class PictureLimit { Pixels, Side };
/// Adds --size, --scale and --area.
void addViewOptions(CommandLine &line);
/// --size, --scale, --area and --time of the command line, as far as the command has them. Errors are usage errors.
Result<PictureOptions> pictureOptions(const CommandLine &line, const Painting &painting,
                                      PictureLimit limit = PictureLimit::Pixels);
/// --time alone; default the end. Not before time 0, nor before the first stroke where that is earlier.
Result<Microseconds> timeOption(const CommandLine &line, const Painting &painting);
/// --backend, --threads and --devices, as far as the command has them. Errors are usage errors.
Result<RendererOptions> rendererOptions(const CommandLine &line);

/// True after SIGINT or SIGTERM: work stops and nothing is left behind. Installs the handler on the first call.
const std::atomic<bool> &interrupted();

/// Draws the whole request, with a progress line on stderr where that is a terminal.
Result<RenderStats> renderPicture(Renderer &renderer, const RenderRequest &request, FloatPicture &picture);

} // namespace suffuse::cli
