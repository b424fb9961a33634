// suffuse-cli timelapse as one file.
#include "tests/cli/cli_process.h"

#include <QDir>
#include <QProcess>
#include <QStandardPaths>
#include <QTemporaryDir>
#include <QTest>

namespace {

const QByteArray painting = R"({"format": "suffuse-text", "version": 1,
 "canvas": {"width": 40, "height": 31, "background": [0, 0, 0, 1], "paper": {"kind": "none"}},
 "strokes": [{"id": 1, "style": {"kind": "uniform", "xi": [0.4, 0.1]}, "mix": {"mode": "alpha"}, "segments": [
  {"bezier": [[8, 15], [16, 15], [24, 15], [32, 15]], "diffusion": 4, "density": 9, "granulation": 1, "maxAge": 1, "born": 0,
   "colour": [1, 0, 0, 1]}]}]})";

} // namespace

class TestFilms : public QObject {
    Q_OBJECT

private slots:
    void initTestCase() { QVERIFY(writeFile(path("a.json"), painting)); }

    void animatedWebP()
    {
        const CliOutcome made = runCli({"timelapse", path("a.json"), "-o", path("film.webp"), "--duration", "1",
                                        "--fps", "8", "--transparent", "--once", "--stats"});
        QVERIFY2(made.code == 0, qPrintable(made.text()));
        QCOMPARE(made.json()["frames"].toInt(), 8);
        const QByteArray file = readFile(path("film.webp"));
        QVERIFY(file.startsWith("RIFF") && file.mid(8, 8) == "WEBPVP8X");
        QCOMPARE(file.count("ANMF"), 8);
        QCOMPARE(file.mid(file.indexOf("ANIM") + 12, 2), QByteArray("\1\0", 2));
        QCOMPARE(QDir(m_folder.path()).entryList({".suffuse*"}, QDir::Files | QDir::Hidden), QStringList());
    }

    void video()
    {
        if (QStandardPaths::findExecutable("ffmpeg").isEmpty() || QStandardPaths::findExecutable("ffprobe").isEmpty())
            QSKIP("ffmpeg is not installed");
        for (const QString name : {"film.webm", "film.mp4"}) {
            const CliOutcome made =
                runCli({"timelapse", path("a.json"), "-o", path(name), "--duration", "2", "--fps", "10"});
            QVERIFY2(made.code == 0, qPrintable(made.text()));
            QProcess probe;
            probe.start("ffprobe", {"-v", "error", "-count_frames", "-show_entries",
                                    "stream=width,height,nb_read_frames", "-of", "csv=p=0", path(name)});
            QVERIFY(probe.waitForFinished());
            QCOMPARE(probe.readAllStandardOutput().trimmed(),
                     QByteArray(name.endsWith("mp4") ? "40,32,20" : "40,31,20"));
        }
    }

    void mistakesAndStops()
    {
        const CliOutcome alpha = runCli({"timelapse", path("a.json"), "-o", path("x.mp4"), "--transparent"});
        QVERIFY2(alpha.code == 2 && alpha.err.contains("WebM"), qPrintable(alpha.text()));
        const CliOutcome nowhere = runCli({"timelapse", path("a.json"), "-o", path("nowhere/x.webp")});
        QVERIFY2(nowhere.code == 1 && nowhere.err.contains("nowhere"), qPrintable(nowhere.text()));
        const QStringList before = QDir(m_folder.path()).entryList(QDir::AllEntries | QDir::Hidden);
        QStringList names{"stopped.webp"};
        if (QStandardPaths::findExecutable("ffmpeg").isEmpty()) {
            const CliOutcome video = runCli({"timelapse", path("a.json"), "-o", path("x.webm")});
            QVERIFY2(video.code == 1 && video.err.contains("ffmpeg"), qPrintable(video.text()));
        } else {
            names.append("stopped.webm");
        }
        for (const QString &name : names) {
            QProcess process;
            process.start(QStringLiteral(SUFFUSE_BIN_DIR "/suffuse-cli"),
                          {"timelapse", path("a.json"), "-o", path(name), "--duration", "5000", "--size", "640"});
            QVERIFY(process.waitForStarted());
            QTRY_VERIFY(QDir(m_folder.path()).entryList(QDir::AllEntries | QDir::Hidden) != before);
            process.terminate();
            QVERIFY(process.waitForFinished());
            QCOMPARE(process.exitCode(), 1);
            QVERIFY(process.readAllStandardError().contains("nothing was written"));
            QCOMPARE(QDir(m_folder.path()).entryList(QDir::AllEntries | QDir::Hidden), before);
        }
    }

private:
    QString path(const QString &name) const { return m_folder.filePath(name); }
    QTemporaryDir m_folder;
};

QTEST_GUILESS_MAIN(TestFilms)
#include "test_films.moc"
