// Every text that people read is in every file of translations, under the name by which the program looks it up.
#include <QDir>
#include <QFile>
#include <QLibraryInfo>
#include <QProcess>
#include <QRegularExpression>
#include <QStandardPaths>
#include <QTemporaryDir>
#include <QTest>

class TestTranslations : public QObject {
    Q_OBJECT

private slots:
    void all_data()
    {
        QTest::addColumn<QString>("language");
        for (const char *language : {"de", "zh_CN", "fr", "es", "ja", "en"})
            QTest::newRow(language) << language;
    }

    /// lupdate, as the target update_translations calls it, finds nothing that is missing.
    void all()
    {
        QFETCH(QString, language);
        QString lupdate = QStandardPaths::findExecutable("lupdate", {QLibraryInfo::path(QLibraryInfo::BinariesPath)});
        if (lupdate.isEmpty())
            QSKIP("lupdate is not installed");
        const QString name = QStringLiteral("suffuse_%1.ts").arg(language), source = SUFFUSE_SOURCE_DIR;
        QTemporaryDir folder;
        QVERIFY(QFile::copy(QDir(source).filePath("i18n/" + name), folder.filePath(name)));
        QStringList arguments{"-silent", "-no-obsolete", "-locations", "none", "-source-language", "en",    "-I", ".",
                              "model",   "undo",         "render",     "app",  "-target-language", language};
        if (language == "en") // It has plural forms alone.
            arguments << "-pluralonly";
        QProcess process;
        process.setWorkingDirectory(source);
        process.setProcessChannelMode(QProcess::MergedChannels);
        process.start(lupdate, arguments << "-ts" << folder.filePath(name));
        QVERIFY(process.waitForFinished(-1));
        QVERIFY2(process.exitCode() == 0, process.readAll().constData());
        QFile updated(folder.filePath(name));
        QVERIFY(updated.open(QIODevice::ReadOnly));
        const QString text = QString::fromUtf8(updated.readAll());
        QStringList missing;
        static const QRegularExpression unfinished("<source>([^<]*)</source>\\s*(<[^t][^\\n]*\\s*)*"
                                                   "<translation type=\"unfinished\"");
        for (auto it = unfinished.globalMatch(text); it.hasNext();)
            missing << it.next().captured(1);
        QCOMPARE(missing, QStringList());
        QVERIFY(!text.contains("type=\"unfinished\""));
        QVERIFY(!text.contains(QStringLiteral("单击"))); // A click has one name in Chinese: 点击.
    }
};

QTEST_GUILESS_MAIN(TestTranslations)
#include "test_translations.moc"
