// The canvas in the colours of a screen and of a soft proof.
#include "app/dialogs/colour_page.h"
#include "app/dialogs/settings_dialog.h"
#include "app/session/settings/colour_settings.h"
#include "app/widgets/asking/messages.h"
#include "tests/app/file_dialogs.h"
#include "tests/app/session.h"
#include "tests/wide_profile.h"

#include <QComboBox>
#include <QLabel>
#include <QPushButton>
#include <QTemporaryDir>

using namespace suffuse;

class TestProofing : public QObject {
    Q_OBJECT

    QTemporaryDir m_folder;
    QString path(const char *name) const { return m_folder.filePath(QLatin1String(name)); }

    /// What the canvas shows of the sheet's middle, where there is a red wash and nothing over it.
    static QRgb middle(Session &s)
    {
        s.dry();
        const QImage shot = s.canvas().grab().toImage();
        return shot.pixel(shot.width() / 2, shot.height() / 2);
    }
    static void paintRed(Session &s)
    {
        s.editor().newPainting(Canvas{});
        Brush brush = builtinBrushes().front();
        brush.colour = {1, 0, 0, 1};
        brush.setSpread(40);
        s.editor().setBrush(brush);
        s.use(Command::Brush);
        const Rect sheet = s.painting().canvas.area();
        s.paintLine({sheet.left + 200, sheet.height() / 2}, {sheet.right - 200, sheet.height() / 2});
        s.use(Command::HideDocks);
    }
    static QRgb converted(QRgb colour, const ColourProfiles &profiles)
    {
        std::uint32_t pixel = colour | 0xFF000000;
        ScreenColours(*ColourConversion::between(profiles)).convert(&pixel, 1);
        return pixel;
    }

private slots:
    void init()
    {
        qputenv("SUFFUSE_SETTINGS", path("settings.ini").toUtf8());
        settings::setColours({});
        QFile file(path("wide.icc"));
        QVERIFY(file.open(QIODevice::WriteOnly) && file.write(test::wideProfile()) > 0);
        QFile broken(path("broken.icc"));
        QVERIFY(broken.open(QIODevice::WriteOnly) && broken.write("no profile") > 0);
    }

    void screenProfileOfTheSettings()
    {
        Session s;
        paintRed(s);
        const QRgb plain = middle(s);
        QVERIFY(qRed(plain) > 200 && qGreen(plain) < 60);
        int answered = 0;
        whenAsked<SettingsDialog>(this, answered, [&](SettingsDialog &dialog) {
            ColourPage &page = *dialog.colours();
            int chosen = 0;
            whenAskedForFile(&dialog, chosen, path("wide.icc"));
            page.screen()->setCurrentIndex(2);
            emit page.screen()->activated(2);
            QCOMPARE(chosen, 1);
            QVERIFY(page.screenFile()->isEnabled());
            dialog.accept();
        });
        s.use(Command::Settings);
        QCOMPARE(answered, 1);
        const QRgb expected = converted(plain, {{}, test::wideProfile(), {}});
        QVERIFY(expected != plain);
        QCOMPARE(middle(s), expected);
        // The picture is what it was, and so is what the eyedropper finds.
        QCOMPARE(s.canvas().picture().pixel(s.canvas().view().width / 2, s.canvas().view().height / 2), plain);

        ColourSettings colours = settings::colours();
        colours.screen = ScreenProfile::None;
        settings::setColours(colours);
        s.canvas().readColours();
        QCOMPARE(middle(s), plain);
    }

    /// The device has all that sRGB has, so nothing changes and nothing is marked; the sign says that it is looked at.
    void softProof()
    {
        Session s;
        paintRed(s);
        const QRgb plain = middle(s);
        QAction &proof = s.window.action(Command::SoftProof);
        auto *sign = s.window.findChild<QLabel *>("proof");
        QVERIFY(sign && !sign->isVisible());
        QVERIFY(!proof.isChecked() && !s.window.action(Command::GamutWarning).isEnabled());
        ColourSettings colours;
        colours.screen = ScreenProfile::None;
        settings::setColours(colours);
        int chosen = 0;
        whenAskedForFile(&s.window, chosen, path("wide.icc"));
        proof.trigger();
        QCOMPARE(chosen, 1);
        QVERIFY(proof.isChecked() && settings::colours().proofs);
        QVERIFY(sign->isVisible() && sign->text().startsWith("Proof: "));
        QCOMPARE(middle(s), plain); // It has all of sRGB.
        s.window.action(Command::GamutWarning).trigger();
        QVERIFY(s.window.action(Command::GamutWarning).isChecked());
        QCOMPARE(middle(s), plain);
        proof.trigger();
        QVERIFY(!proof.isChecked() && !sign->isVisible());
        proof.trigger(); // The profile is known now.
        QVERIFY(proof.isChecked() && sign->isVisible());
    }

    void brokenProfilesAreSaid()
    {
        QStringList errors;
        setMessageHooks({[&errors](const QString &message) { errors << message; }});
        Session s;
        int chosen = 0;
        whenAskedForFile(&s.window, chosen, path("broken.icc"));
        s.use(Command::ProofProfile);
        QCOMPARE(chosen, 1);
        QCOMPARE(errors.size(), 1);
        QVERIFY2(errors.front().contains("broken.icc"), qPrintable(errors.front()));
        QVERIFY(!settings::colours().proofs);
        setMessageHooks({});

        ColourSettings colours;
        colours.screen = ScreenProfile::File;
        colours.screenFile = path("gone.icc");
        settings::setColours(colours);
        s.canvas().readColours();
        auto *sign = s.window.findChild<QLabel *>("proof");
        QVERIFY(sign->isVisible() && sign->toolTip().contains("gone.icc"));
    }

    /// All windows follow, and one that is opened later as well.
    void allWindows()
    {
        Session one, two;
        paintRed(one);
        paintRed(two);
        const QRgb plain = middle(one);
        ColourSettings colours;
        colours.screen = ScreenProfile::File;
        colours.screenFile = path("wide.icc");
        colours.proofFile = path("wide.icc");
        settings::setColours(colours);
        one.use(Command::SoftProof);
        const QRgb expected = converted(plain, {{}, test::wideProfile(), {}});
        QCOMPARE(middle(one), expected);
        QCOMPARE(middle(two), expected);
        Session three;
        paintRed(three);
        QCOMPARE(middle(three), expected);
    }
};

QTEST_MAIN(TestProofing)
#include "test_proofing.moc"
