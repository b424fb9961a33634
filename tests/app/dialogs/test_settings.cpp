// Settings: what is stored comes back, and damaged files never keep the program from starting.
#include "app/session/settings/settings.h"
#include "app/session/translation.h"
#include "app/widgets/look/theme.h"
#include "app/window/layout/window_layout.h"
#include "model/formats/atomic_save.h"
#include "tests/trials.h"

#include <QApplication>
#include <QDockWidget>
#include <QMainWindow>
#include <QPalette>
#include <QRandomGenerator>
#include <QTemporaryDir>
#include <QTest>

#include <cmath>

using namespace suffuse;

namespace {

/// Relative luminance after WCAG 2.
double luminance(const QColor &colour)
{
    const auto linear = [](double c) { return c <= 0.03928 ? c / 12.92 : std::pow((c + 0.055) / 1.055, 2.4); };
    return 0.2126 * linear(colour.redF()) + 0.7152 * linear(colour.greenF()) + 0.0722 * linear(colour.blueF());
}

double contrast(const QColor &a, const QColor &b)
{
    const double high = std::max(luminance(a), luminance(b)), low = std::min(luminance(a), luminance(b));
    return (high + 0.05) / (low + 0.05);
}

void addDocks(QMainWindow &window)
{
    for (const char *name : {"one", "two", "three"}) {
        auto *dock = new QDockWidget(QString::fromLatin1(name), &window);
        dock->setObjectName(name);
        dock->setWidget(new QWidget(dock));
        window.addDockWidget(Qt::RightDockWidgetArea, dock);
    }
}

} // namespace

class TestSettings : public QObject {
    Q_OBJECT

private slots:
    void init()
    {
        m_folder = std::make_unique<QTemporaryDir>();
        QVERIFY(m_folder->isValid());
        useFile("settings.ini");
    }

    void valuesComeBack()
    {
        settings::setLanguage("de");
        settings::setTheme(settings::Theme::Dark);
        settings::setPresenter(settings::Presenter::OpenGL);
        settings::setBackend(Backend::Cpu);
        settings::setThreads(3);
        QCOMPARE(settings::language(), QString("de"));
        QCOMPARE(settings::theme(), settings::Theme::Dark);
        QCOMPARE(settings::presenter(), settings::Presenter::OpenGL);
        QCOMPARE(settings::backend(), Backend::Cpu);
        QCOMPARE(settings::threads(), 3);
    }

    void nonsenseCountsAsDefault()
    {
        settings::store().setValue("language", "klingon");
        settings::store().setValue("theme", 17);
        settings::store().setValue("presenter", "smoke");
        settings::store().setValue("backend", "abacus");
        settings::store().setValue("threads", -5);
        QCOMPARE(settings::language(), QString());
        QCOMPARE(settings::theme(), settings::Theme::System);
        QCOMPARE(settings::presenter(), settings::Presenter::Auto);
        QCOMPARE(settings::backend(), Backend::Auto);
        QCOMPARE(settings::threads(), 0);
    }

    void recentFilesNewestFirst()
    {
        QStringList paths;
        for (int i = 0; i < 12; ++i) {
            paths << m_folder->filePath(QString("%1.suffuse").arg(i));
            QFile file(paths.last());
            QVERIFY(file.open(QIODevice::WriteOnly));
            settings::addRecentFile(paths.last());
        }
        settings::addRecentFile(paths[5]);
        const QStringList recent = settings::recentFiles();
        QCOMPARE(recent.size(), 10);
        QCOMPARE(recent[0], paths[5]);
        QCOMPARE(recent[1], paths[11]);
        QCOMPARE(recent.count(paths[5]), 1);
        QVERIFY(QFile::remove(paths[11]));
        QVERIFY(!settings::recentFiles().contains(paths[11]));
        settings::clearRecentFiles();
        QVERIFY(settings::recentFiles().isEmpty());
    }

    void layoutComesBack()
    {
        QMainWindow window;
        addDocks(window);
        window.findChild<QDockWidget *>("two")->hide();
        window.addDockWidget(Qt::LeftDockWidgetArea, window.findChild<QDockWidget *>("three"));
        window.resize(700, 500);
        QVERIFY(!window_layout::isStored());
        window_layout::save(window);
        QVERIFY(window_layout::isStored());

        QMainWindow other;
        addDocks(other);
        QVERIFY(window_layout::restore(other));
        QVERIFY(other.findChild<QDockWidget *>("two")->isHidden());
        QCOMPARE(other.dockWidgetArea(other.findChild<QDockWidget *>("three")), Qt::LeftDockWidgetArea);
        other.show();
        QTRY_VERIFY(!settings::store().value("layout/starting").toBool());
    }

    void failedStartSkipsTheLayout()
    {
        QMainWindow window;
        addDocks(window);
        window_layout::save(window);
        {
            QMainWindow never; // restored, but never shown: as if the program had died
            addDocks(never);
            QVERIFY(window_layout::restore(never));
        }
        QMainWindow next;
        addDocks(next);
        QVERIFY(!window_layout::restore(next));
        QVERIFY(!window_layout::isStored());
    }

    void damagedFilesStillStart()
    {
        QMainWindow window;
        addDocks(window);
        settings::setLanguage("zh_CN");
        settings::addRecentFile(QCoreApplication::applicationFilePath());
        window_layout::save(window);
        settings::store().sync();
        QFile file(m_folder->filePath("settings.ini"));
        QVERIFY(file.open(QIODevice::ReadOnly));
        const QByteArray whole = file.readAll();
        QVERIFY(whole.size() > 200);

        QRandomGenerator random(7);
        int restored = 0;
        const int trials = isLongRun() ? 10'000 : 500;
        for (int i = 0; i < trials; ++i) {
            QByteArray damaged = whole;
            const int flips = 1 + i % 4;
            for (int k = 0; k < flips; ++k) {
                const qsizetype at = random.bounded(damaged.size());
                damaged[at] = char(damaged[at] ^ (1 << random.bounded(8)));
            }
            if (i % 10 == 0)
                damaged.truncate(random.bounded(damaged.size()));
            const QString name = QString("damaged%1.ini").arg(i);
            QFile out(m_folder->filePath(name));
            QVERIFY(out.open(QIODevice::WriteOnly));
            out.write(damaged);
            out.close();
            useFile(name);
            settings::beginStart();
            QVERIFY(settings::language().isEmpty() || translationCodes().contains(settings::language()));
            QVERIFY(settings::threads() >= 0 && settings::threads() <= 256);
            QVERIFY(settings::recentFiles().size() <= 10);
            installTranslators();
            applyTheme();
            QMainWindow started;
            addDocks(started);
            if (window_layout::restore(started))
                ++restored;
            settings::startSucceeded();
            QFile::remove(out.fileName());
        }
        // Where the damage lay elsewhere the layout is kept; where it lay in the layout it is not.
        QVERIFY(restored > 0);
        QVERIFY(restored < trials);
    }

    /// One failed start may be an accident; after two the settings are kept aside.
    void settingsThatNeverStartArePutAside()
    {
        settings::setTheme(settings::Theme::Dark);
        settings::store().sync();
        QVERIFY(settings::beginStart().isEmpty());
        settings::startSucceeded();
        QVERIFY(settings::beginStart().isEmpty()); // these two never came up
        QVERIFY(settings::beginStart().isEmpty());
        const QString aside = settings::beginStart();
        QVERIFY(QFile::exists(aside));
        useFile("other.ini"); // so that the store is opened anew, as by a new start
        settings::store();
        useFile("settings.ini");
        QCOMPARE(settings::theme(), settings::Theme::System);
        settings::startSucceeded();
        QVERIFY(settings::beginStart().isEmpty());
        settings::startSucceeded();
    }

    void backupsAreBounded()
    {
        QCOMPARE(settings::backups(), 2); // nobody has to know of them to have them
        settings::setBackups(0);
        QCOMPARE(settings::backups(), 0);
        settings::setBackups(3);
        QCOMPARE(settings::backups(), 3);
        settings::store().setValue("backups", 1'000'000);
        QCOMPARE(settings::backups(), mostBackups);
        settings::store().setValue("backups", "many");
        QCOMPARE(settings::backups(), 2);
    }

    void palettesHaveContrast()
    {
        for (const QPalette &p : {lightPalette(), darkPalette()}) {
            QVERIFY(contrast(p.color(QPalette::WindowText), p.color(QPalette::Window)) >= 4.5);
            QVERIFY(contrast(p.color(QPalette::Text), p.color(QPalette::Base)) >= 4.5);
            QVERIFY(contrast(p.color(QPalette::ButtonText), p.color(QPalette::Button)) >= 4.5);
            QVERIFY(contrast(p.color(QPalette::HighlightedText), p.color(QPalette::Highlight)) >= 4.5);
            QVERIFY(contrast(p.color(QPalette::PlaceholderText), p.color(QPalette::Window)) >= 4.5);
            QVERIFY(contrast(p.color(QPalette::ToolTipText), p.color(QPalette::ToolTipBase)) >= 4.5);
            QVERIFY(contrast(p.color(QPalette::Link), p.color(QPalette::Base)) >= 4.5);
        }
        for (const settings::Theme theme : {settings::Theme::Light, settings::Theme::Dark}) {
            settings::setTheme(theme);
            applyTheme();
            QCOMPARE(isDarkTheme(), theme == settings::Theme::Dark);
            QVERIFY(contrast(warningText(), QApplication::palette().color(QPalette::Window)) >= 4.5);
        }
    }

    /// The last one: what is forgotten stays forgotten.
    void safeModeNeitherReadsNorWrites()
    {
        settings::setTheme(settings::Theme::Dark);
        settings::store().sync();
        QFile file(m_folder->filePath("settings.ini"));
        QVERIFY(file.open(QIODevice::ReadOnly));
        const QByteArray before = file.readAll();
        settings::forgetEverything();
        QCOMPARE(settings::theme(), settings::Theme::System);
        settings::setTheme(settings::Theme::Light);
        QCOMPARE(settings::theme(), settings::Theme::Light);
        settings::store().sync();
        file.seek(0);
        QCOMPARE(file.readAll(), before);
    }

private:
    void useFile(const QString &name) { qputenv("SUFFUSE_SETTINGS", m_folder->filePath(name).toUtf8()); }

    std::unique_ptr<QTemporaryDir> m_folder;
};

QTEST_MAIN(TestSettings)
#include "test_settings.moc"
