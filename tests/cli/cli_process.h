// Runs the built suffuse-cli as its users do.
#pragma once

#include <QDir>
#include <QFile>
#include <QJsonDocument>
#include <QJsonObject>
#include <QProcess>
#include <QTemporaryDir>

struct CliOutcome {
    int code = -1; ///< -1: it did not start, crashed or hung
    QByteArray out;
    QByteArray err;

    QString text() const
    {
        return QString("exit %1\n%2%3").arg(code).arg(QString::fromUtf8(out), QString::fromUtf8(err));
    }
    QJsonObject json() const { return QJsonDocument::fromJson(out).object(); }
};

/// Without a display. `environment`: "NAME=value" pairs on top.
inline CliOutcome runCli(const QStringList &arguments, const QByteArray &input = {},
                         const QStringList &environment = {})
{
    QProcess process;
    QProcessEnvironment variables = QProcessEnvironment::systemEnvironment();
    for (const char *name : {"DISPLAY", "WAYLAND_DISPLAY", "QT_QPA_PLATFORM", "SUFFUSE_MODULE_DIR"})
        variables.remove(name);
    variables.insert("LC_ALL", "C.UTF-8");
    for (const QString &e : environment)
        variables.insert(e.section('=', 0, 0), e.section('=', 1));
    process.setProcessEnvironment(variables);
    process.start(QStringLiteral(SUFFUSE_BIN_DIR "/suffuse-cli"), arguments);
    CliOutcome outcome;
    if (!process.waitForStarted())
        return outcome;
    process.write(input);
    process.closeWriteChannel();
    if (!process.waitForFinished(600'000)) {
        process.kill();
        process.waitForFinished();
        return outcome;
    }
    outcome.code = process.exitStatus() == QProcess::NormalExit ? process.exitCode() : -1;
    outcome.out = process.readAllStandardOutput();
    outcome.err = process.readAllStandardError();
    return outcome;
}

inline bool writeFile(const QString &path, const QByteArray &bytes)
{
    QFile file(path);
    return file.open(QIODevice::WriteOnly) && file.write(bytes) == bytes.size();
}

inline QByteArray readFile(const QString &path)
{
    QFile file(path);
    return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
}

/// Everything in a folder, hidden files included.
inline QStringList filesIn(const QString &folder)
{
    return QDir(folder).entryList(QDir::AllEntries | QDir::Hidden | QDir::System | QDir::NoDotAndDotDot, QDir::Name);
}

/// Two strokes on a 40 × 30 canvas: a straight blue one across the middle, a red dot of pigment at the right.
inline QByteArray smallPainting()
{
    return R"({"format": "suffuse-text", "version": 1,
 "canvas": {"width": 40, "height": 30, "background": [0,0,0,1], "paper": {"kind": "none"}},
 "strokes": [
  {"id": 1, "name": "bar", "group": null, "visible": true, "locked": false,
   "style": {"kind": "uniform", "xi": [0.5, 0.05]}, "mix": {"mode": "alpha"},
   "segments": [
    {"bezier": [[5,15],[10,15],[15,15],[20,15]], "diffusion": 2, "density": 6, "granulation": 1, "maxAge": 1, "born": 0,
     "colour": [0,0,1,1]},
    {"bezier": [[20,15],[25,15],[30,15],[35,15]], "diffusion": 2, "density": 6, "granulation": 1, "maxAge": 1, "born": 0.5,
     "colour": [0,0,1,1]}]},
  {"id": 2, "name": "", "group": null, "visible": true, "locked": false,
   "style": {"kind": "feathering", "xi": [0.5, 2]}, "mix": {"mode": "beta", "beta": 0.8},
   "segments": [
    {"bezier": [[30,8],[30,8.3],[30,8.6],[30,9]], "diffusion": 3, "density": 30, "granulation": 1, "maxAge": 1, "born": 2,
     "colour": [1,0,0,0.9]}]}]})";
}
