// The picture's colours as the screen gets them.
#include "app/session/colour/screen_colours.h"
#include "app/session/settings/colour_settings.h"
#include "tests/wide_profile.h"

#include <QRandomGenerator>
#include <QTemporaryDir>
#include <QTest>

#include <cmath>

using namespace suffuse;

class TestScreenColours : public QObject {
    Q_OBJECT

    QTemporaryDir m_folder;

    QString profileFile() const
    {
        const QString path = m_folder.filePath("wide.icc");
        QFile file(path);
        return file.open(QIODevice::WriteOnly) && file.write(test::wideProfile()) > 0 ? path : QString();
    }

private slots:
    void initTestCase()
    {
        qputenv("SUFFUSE_SETTINGS", m_folder.filePath("settings.ini").toUtf8());
        QVERIFY(!test::wideProfile().isEmpty());
    }

    /// Each pixel is what the conversion makes of it, rounded once, in whatever pieces pixels come.
    void convertsAsTheProfileSays()
    {
        const Result<ColourConversion> conversion = ColourConversion::between({{}, test::wideProfile(), {}});
        QVERIFY2(conversion, qPrintable(conversion.error()));
        const ScreenColours colours(*conversion);
        QVERIFY(!colours.changesNothing());
        QRandomGenerator random(11);
        std::vector<std::uint32_t> pixels(20'000);
        for (std::uint32_t &pixel : pixels)
            pixel = 0xFF000000 | (random() & (random() % 2 ? 0x1F1F1F : 0xFFFFFF)); // many are there twice
        const std::vector<std::uint32_t> before = pixels;
        for (std::size_t at = 0; at < pixels.size(); at += 700)
            colours.convert(pixels.data() + at, std::min<std::size_t>(700, pixels.size() - at));
        int differ = 0;
        for (std::size_t i = 0; i < pixels.size(); ++i) {
            float v[4] = {float(before[i] >> 16 & 255) / 255, float(before[i] >> 8 & 255) / 255,
                          float(before[i] & 255) / 255, 1};
            conversion->apply(v, 1);
            std::uint32_t expected = 0xFF;
            for (int c = 0; c < 3; ++c)
                expected = expected << 8 | std::uint32_t(std::lround(std::clamp(v[c], 0.0f, 1.0f) * 255));
            QCOMPARE(pixels[i], expected);
            differ += pixels[i] != before[i];
        }
        QVERIFY(differ > 10'000);
        std::vector<std::uint32_t> plain = before;
        ScreenColours().convert(plain.data(), plain.size());
        QVERIFY(plain == before);
    }

    void settingsComeBack()
    {
        QVERIFY(settings::colours() == ColourSettings());
        ColourSettings colours{ScreenProfile::File, "/s.icc", true, true, "/p.icc", RenderingIntent::Perceptual, false};
        settings::setColours(colours);
        QVERIFY(settings::colours() == colours);
        colours.proofFile.clear(); // There is nothing to show then.
        settings::setColours(colours);
        QVERIFY(!settings::colours().proofs);
    }

    void profilesOfSettings()
    {
        const QString file = profileFile();
        QVERIFY(!file.isEmpty());
        ColourSettings colours;
        QVERIFY(screenConversion(colours, {})->changesNothing());
        QVERIFY(!screenConversion(colours, test::wideProfile())->changesNothing());
        colours.screen = ScreenProfile::None;
        QVERIFY(screenConversion(colours, test::wideProfile())->changesNothing());
        colours.screen = ScreenProfile::File;
        colours.screenFile = file;
        QVERIFY(!screenConversion(colours, {})->changesNothing());
        colours.screenFile = m_folder.filePath("gone.icc");
        const Result<ColourConversion> gone = screenConversion(colours, {});
        QVERIFY(!gone && gone.error().contains("gone.icc"));
        colours.screen = ScreenProfile::None;
        colours.proofs = true;
        colours.proofFile = file; // wider than sRGB: all colours are there
        QVERIFY(screenConversion(colours, {})->changesNothing());
    }
};

QTEST_GUILESS_MAIN(TestScreenColours)
#include "test_screen_colours.moc"
