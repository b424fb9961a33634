#pragma once

#include <QByteArray>
#include <QComboBox>

namespace suffuse {

/// In which colours a picture is written: sRGB, or an RGB profile, which the document keeps.
class ProfileBox : public QComboBox {
    Q_OBJECT

public:
    /// `kept`: the document's profile; empty if it has none.
    ProfileBox(const QByteArray &kept, QWidget *parent);

    /// What was chosen; empty: sRGB.
    QByteArray profile() const { return currentIndex() == keptIndex ? m_profile : QByteArray(); }
    /// The profile that the document is to keep, whether or not it was chosen.
    const QByteArray &kept() const { return m_profile; }
    /// Chooses the document's profile, if it has one, or sRGB.
    void chooseKept(bool kept);
    /// Takes the profile of a file. Returns why it cannot; empty: it is chosen.
    QString takeFile(const QString &path);

signals:
    /// A file was chosen that cannot be taken.
    void refused(const QString &why);

private:
    static constexpr int srgbIndex = 0, keptIndex = 1; // then the file; without a profile it comes second

    bool hasKept() const { return !m_profile.isEmpty(); }
    void fill(int index);
    void askForFile();

    QByteArray m_profile;
    int m_before = srgbIndex; ///< what was chosen before a file is asked for
};

} // namespace suffuse
