#include "app/extensions/extension_run.h"

#include "app/extensions/confinement.h"
#include "app/extensions/field_values.h"
#include "app/extensions/found_extensions.h"
#include "app/extensions/passed_part.h"
#include "model/formats/files.h"

#include <QDir>
#include <QElapsedTimer>
#include <QFile>
#include <QFileInfo>
#include <QJsonArray>
#include <QJsonDocument>
#include <QProcess>
#include <QTemporaryDir>

#include <algorithm>
#include <fcntl.h>
#include <signal.h>
#include <unistd.h>
#include <utility>

namespace suffuse {

namespace {

constexpr int pollMs = 20, usePollMs = 100;
constexpr qsizetype longestLog = 16'384, longestLine = 4096;

/// What comes on standard error: progress, what is to be said, and all else.
class ErrorLines {
public:
    ErrorLines(ExtensionOutcome &outcome, const std::function<void(double, const QString &)> &progress)
        : m_outcome(outcome), m_progress(progress)
    {}

    void add(const QByteArray &bytes)
    {
        m_rest += bytes;
        for (qsizetype end; (end = m_rest.indexOf('\n')) >= 0; m_rest.remove(0, end + 1))
            line(m_rest.left(end));
        if (m_rest.size() > longestLine) {
            line(m_rest.left(longestLine));
            m_rest.clear();
        }
    }
    void finish()
    {
        if (!m_rest.isEmpty())
            line(std::exchange(m_rest, {}));
    }

    /// What the program itself says that went wrong.
    const QString &problem() const { return m_problem; }

private:
    void line(const QByteArray &bytes)
    {
        const QString text = QString::fromUtf8(bytes.left(longestLine)).trimmed();
        if (text.startsWith(QLatin1String("progress:"))) {
            const QString rest = text.mid(9).trimmed();
            bool isNumber = false;
            const double share = rest.section(' ', 0, 0).toDouble(&isNumber);
            if (m_progress && isNumber)
                m_progress(std::clamp(share, 0.0, 1.0), rest.section(' ', 1).trimmed());
        } else if (text.startsWith(QLatin1String("say:"))) {
            m_outcome.said = text.mid(4).trimmed().left(500);
        } else if (text.startsWith(QLatin1String("error:"))) {
            m_problem = text.mid(6).trimmed().left(500);
        } else if (!text.isEmpty()) {
            m_outcome.log += text + '\n';
            if (m_outcome.log.size() > 2 * longestLog)
                m_outcome.log = m_outcome.log.right(longestLog);
        }
    }

    ExtensionOutcome &m_outcome;
    const std::function<void(double, const QString &)> &m_progress;
    QByteArray m_rest;
    QString m_problem;
};

/// A file that a program made: no link, no pipe, and no larger than it may be.
Result<QByteArray> resultBytes(const QString &path, qint64 most)
{
    const int handle = open(QFile::encodeName(path).constData(), O_RDONLY | O_NOFOLLOW | O_NONBLOCK | O_CLOEXEC);
    if (handle < 0)
        return Error{ExtensionMessages::tr("it wrote no result")};
    QFile file;
    if (!file.open(handle, QIODevice::ReadOnly, QFileDevice::AutoCloseHandle)) {
        close(handle);
        return Error{ExtensionMessages::tr("its result cannot be read")};
    }
    if (file.isSequential())
        return Error{ExtensionMessages::tr("its result is no file")};
    if (file.size() > most)
        return Error{ExtensionMessages::tr("its result is too large")};
    const QByteArray bytes = file.readAll();
    return bytes.isEmpty() ? Result<QByteArray>(Error{ExtensionMessages::tr("its result is empty")}) : bytes;
}

/// One run, with its folder, which goes with it.
class ExtensionRun {
public:
    ExtensionRun(const ExtensionOrder &order, const std::atomic<bool> &cancel,
                 const std::function<void(double, const QString &)> &progress)
        : m_order(order), m_cancel(cancel), m_lines(m_outcome, progress)
    {}

    ExtensionOutcome outcome()
    {
        const QString error = run();
        if (m_outcome.cancelled)
            m_outcome.painting.reset();
        else if (!error.isEmpty())
            m_outcome.error = QStringLiteral("%1: %2").arg(m_order.extension.name.in(m_order.language), error);
        if (!m_outcome.error.isEmpty())
            m_outcome.painting.reset();
        return std::move(m_outcome);
    }

private:
    QString run()
    {
        const Extension &extension = m_order.extension;
        if (const QString problem = problemOfNeeds(extension); !problem.isEmpty())
            return problem;
        if (const QString problem = problemOfValues(extension, m_order.values, m_order.language); !problem.isEmpty())
            return problem;
        m_passed = passedStrokes(*m_order.painting, extension.passes, m_order.selected, m_order.layer);
        if (extension.passes != Extension::Passes::Painting && m_passed.empty())
            return extension.passes == Extension::Passes::Selection
                       ? ExtensionMessages::tr(
                             "Nothing that is visible and unlocked is selected. Select strokes first.")
                       : ExtensionMessages::tr("Nothing in the layer is visible and unlocked.");
        if (const QString problem = prepare(); !problem.isEmpty())
            return problem;
        if (const QString problem = runProgram(); !problem.isEmpty() || m_outcome.cancelled)
            return problem;
        if (extension.returnsPainting)
            if (const QString problem = takeResult(); !problem.isEmpty())
                return problem;
        return takeFiles();
    }

    QString ending() const { return m_order.extension.asText ? QStringLiteral("json") : QStringLiteral("suffuse"); }
    QString readFolder() const { return m_folder.filePath(QStringLiteral("job")); }
    QString writeFolder() const { return m_folder.filePath(QStringLiteral("work")); }
    QString jobPath() const { return readFolder() + QStringLiteral("/job.json"); }
    QString paintingPath() const { return readFolder() + QStringLiteral("/painting.") + ending(); }
    QString resultPath() const { return writeFolder() + QStringLiteral("/result.") + ending(); }
    /// Where the program writes a file that goes elsewhere afterwards.
    QString filePath(const ExtensionField &field) const
    {
        const QString chosen = m_order.values[field.id].toString();
        for (const QString &ending : field.endings)
            if (chosen.endsWith('.' + ending, Qt::CaseInsensitive))
                return writeFolder() + '/' + field.id + '.' + ending;
        const QString ending = QFileInfo(chosen).suffix();
        return writeFolder() + '/' + field.id + (ending.isEmpty() ? QString() : '.' + ending);
    }

    /// Writes what is handed to the program.
    QString prepare()
    {
        if (!m_folder.isValid() || !QDir().mkpath(readFolder()) || !QDir().mkpath(writeFolder()))
            return ExtensionMessages::tr(
                       "No temporary folder can be made: %1. Set TMPDIR to a folder that can be written.")
                .arg(m_folder.errorString());
        const Painting part = partOf(*m_order.painting, m_passed);
        const QByteArray bytes = m_order.extension.asText ? writeTextForm(part) : writeSuffuseFile(part);
        for (const ExtensionField &field : m_order.extension.fields) {
            QJsonValue value = m_order.values[field.id];
            if (field.type == ExtensionField::Type::File)
                value = field.saves ? filePath(field) : QFileInfo(value.toString()).absoluteFilePath();
            m_values[field.id] = value;
        }
        QJsonArray selection;
        for (const StrokeId id : m_order.selected)
            selection.append(qint64(id));
        const QJsonObject job{{"format", "suffuse-extension-job"},
                              {"version", 1},
                              {"painting", paintingPath()},
                              {"result", resultPath()},
                              {"values", m_values},
                              {"selection", selection},
                              {"layer", m_order.layer ? QJsonValue(qint64(m_order.layer)) : QJsonValue()},
                              {"time", double(m_order.time) * 1e-6},
                              {"language", m_order.language}};
        for (const auto &[path, content] :
             {std::pair(paintingPath(), bytes), {jobPath(), QJsonDocument(job).toJson()}}) {
            QFile file(path);
            if (!file.open(QIODevice::WriteOnly) || file.write(content) != content.size() || !file.flush())
                return ExtensionMessages::tr("%1: cannot be written (%2). Is the disk full?")
                    .arg(path, file.errorString());
        }
        return {};
    }

    /// What a program gets from the environment: what it is to do, and what any program needs. No addresses of buses
    /// and displays, and nothing that people keep there.
    QProcessEnvironment environment() const
    {
        const QProcessEnvironment ours = QProcessEnvironment::systemEnvironment();
        QProcessEnvironment env;
        for (const QString &name : ours.keys())
            if (name == QLatin1String("PATH") || name == QLatin1String("LANG") || name == QLatin1String("TZ") ||
                name == QLatin1String("LD_LIBRARY_PATH") || name.startsWith(QLatin1String("LC_")))
                env.insert(name, ours.value(name));
        addPythonPlaces(env);
        env.insert(QStringLiteral("PYTHONDONTWRITEBYTECODE"), QStringLiteral("1"));
        env.insert(QStringLiteral("PYTHONIOENCODING"), QStringLiteral("utf-8"));
        env.insert(QStringLiteral("HOME"), writeFolder());
        env.insert(QStringLiteral("TMPDIR"), writeFolder());
        env.insert(QStringLiteral("SUFFUSE_JOB"), jobPath());
        env.insert(QStringLiteral("SUFFUSE_PAINTING"), paintingPath());
        env.insert(QStringLiteral("SUFFUSE_RESULT"), resultPath());
        env.insert(QStringLiteral("SUFFUSE_LANGUAGE"), m_order.language);
        for (const ExtensionField &field : m_order.extension.fields)
            env.insert(QStringLiteral("SUFFUSE_VALUE_") + field.id, textOfValue(m_values[field.id]));
        return env;
    }

    /// What it must see: what is handed to it, itself, and files that it is to open.
    QStringList readPlaces() const
    {
        QStringList places{readFolder(), m_order.extension.folder};
        for (const ExtensionField &field : m_order.extension.fields)
            if (field.type == ExtensionField::Type::File && !field.saves)
                places << m_values[field.id].toString();
        return places;
    }

    QString runProgram()
    {
        const ExtensionLimits &limits = m_order.extension.limits;
        const QStringList command =
            confined(commandOf(m_order.extension), {readPlaces(), writeFolder()}, m_order.extension.network);
        const ProcessTree tree("SUFFUSE_JOB=" + QFile::encodeName(jobPath()));
        QProcess process;
        process.setProcessEnvironment(environment());
        process.setWorkingDirectory(writeFolder());
        process.setStandardInputFile(QProcess::nullDevice());
        process.setStandardOutputFile(QProcess::nullDevice());
        process.setReadChannel(QProcess::StandardError);
        process.setChildProcessModifier(limitsModifier(limits));
        process.start(command.first(), command.mid(1));
        if (!process.waitForStarted())
            return ExtensionMessages::tr("The program %1 cannot be started: %2.")
                .arg(command.first(), process.errorString());
        const qint64 leader = process.processId();
        QString ended; ///< why we ended it
        QElapsedTimer clock;
        clock.start();
        for (qint64 looked = 0; process.state() != QProcess::NotRunning && ended.isEmpty();) {
            process.waitForReadyRead(pollMs);
            m_lines.add(process.readAllStandardError());
            if (m_cancel)
                m_outcome.cancelled = true;
            else if (clock.elapsed() > qint64(limits.seconds) * 1000)
                ended = ExtensionMessages::tr("It was ended after %n second(s), which is as long as it may take.",
                                              nullptr, limits.seconds);
            else if (clock.elapsed() - looked >= usePollMs) {
                looked = clock.elapsed();
                ended = excess(tree, limits);
            }
            if (m_outcome.cancelled)
                break;
        }
        const bool hasEnded = process.state() == QProcess::NotRunning;
        tree.end(hasEnded ? 0 : leader); // Whatever it started goes with it.
        process.waitForFinished();
        m_lines.add(process.readAllStandardError());
        m_lines.finish();
        if (m_outcome.cancelled || !ended.isEmpty())
            return ended;
        if (process.exitStatus() != QProcess::NormalExit || process.exitCode() != 0)
            return failure(process);
        return excess(tree, limits);
    }

    /// What it uses more of than it may; empty: nothing.
    QString excess(const ProcessTree &tree, const ExtensionLimits &limits) const
    {
        const qint64 most = qint64(limits.written) * megabyte;
        const ProcessTree::Use use = tree.use();
        if (use.memory > qint64(limits.memory) * megabyte)
            return ExtensionMessages::tr("It was ended, since it took more than %1 MB of memory.").arg(limits.memory);
        if (use.written > 2 * most || bytesWithin(writeFolder(), most) > most)
            return tooMuchWritten();
        return {};
    }

    QString tooMuchWritten() const
    {
        return ExtensionMessages::tr("It was ended, since it wrote more than %1 MB.")
            .arg(m_order.extension.limits.written);
    }

    QString failure(const QProcess &process) const
    {
        if (!m_lines.problem().isEmpty())
            return m_lines.problem();
        const bool wroteTooMuch =
            process.exitCode() == (process.exitStatus() == QProcess::NormalExit ? 128 + SIGXFSZ : SIGXFSZ);
        if (wroteTooMuch)
            return tooMuchWritten();
        const QString last = m_outcome.log.trimmed().section('\n', -1).left(300);
        // Bubblewrap ends with 128 and the signal where its program was killed.
        const bool isKilled = process.exitStatus() != QProcess::NormalExit || process.exitCode() > 128;
        const QString how = isKilled
                                ? ExtensionMessages::tr("The program was killed or crashed. The painting is as it was.")
                                : ExtensionMessages::tr("The program failed (exit code %1). The painting is as it was.")
                                      .arg(process.exitCode());
        return last.isEmpty() ? how : how + ' ' + ExtensionMessages::tr("It wrote: %1").arg(last);
    }

    /// Reads and checks what it made, and puts it into the whole.
    QString takeResult()
    {
        const auto refused = [](const QString &why) {
            return ExtensionMessages::tr("Its result is not used, and the painting is as it was: %1.").arg(why);
        };
        const Result<QByteArray> bytes = resultBytes(resultPath(), qint64(m_order.extension.limits.written) * megabyte);
        if (!bytes)
            return refused(bytes.error());
        const QString name = QFileInfo(resultPath()).fileName();
        Result<Painting> painting =
            m_order.extension.asText ? readTextForm(*bytes, name) : readSuffuseFile(*bytes, name);
        if (!painting)
            return refused(painting.error());
        Result<Painting> whole = withPart(*m_order.painting, m_passed, std::move(*painting));
        if (!whole)
            return refused(whole.error());
        m_outcome.painting = std::make_shared<const Painting>(std::move(*whole));
        return {};
    }

    /// Puts the files that it wrote where people want them: each whole, or not at all.
    QString takeFiles()
    {
        for (const ExtensionField &field : m_order.extension.fields) {
            if (field.type != ExtensionField::Type::File || !field.saves)
                continue;
            const Result<QByteArray> bytes =
                resultBytes(filePath(field), qint64(m_order.extension.limits.written) * megabyte);
            const QString target = QFileInfo(m_order.values[field.id].toString()).absoluteFilePath();
            if (!bytes)
                return ExtensionMessages::tr("%1 was not written: %2.").arg(target, bytes.error());
            if (const Result<void> written = writeFileAtomically(target, *bytes); !written)
                return written.error();
        }
        return {};
    }

    const ExtensionOrder &m_order;
    const std::atomic<bool> &m_cancel;
    QTemporaryDir m_folder;
    std::set<StrokeId> m_passed;
    QJsonObject m_values;
    ExtensionOutcome m_outcome;
    ErrorLines m_lines;
};

} // namespace

ExtensionOutcome runExtension(const ExtensionOrder &order, const std::atomic<bool> &cancel,
                              const std::function<void(double share, const QString &what)> &progress)
{
    return ExtensionRun(order, cancel, progress).outcome();
}

} // namespace suffuse
