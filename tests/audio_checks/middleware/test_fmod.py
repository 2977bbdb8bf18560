"""FMOD Studio: what moves a volume, and what plays what."""

from audio_checks.middleware.fmod import read_fmod
from benchmarks.audits.fmod_project import _object, _objects
from benchmarks.audits.places import guid
from benchmarks.audits.projects import KINDS


def one_event(root, more="", **gains):
    """Write a project of one sound, with more objects in its event's file; read it."""
    path = KINDS["fmod"].write(root, 1, gains)
    (event,) = (root / "Metadata" / "Event").iterdir()
    text = event.read_text()
    event.write_text(text.replace("</objects>", f"{more}</objects>"))
    return path, event


def test_an_automated_volume_depends_on_its_parameter(tmp_path):
    path, event = one_event(
        tmp_path,
        _object("Automator", "AUTO", {"nameOfPropertyBeingAutomated": "volume"}, automationCurves="CURVE")
        + _object("AutomationCurve", "CURVE", {}, parameter="PARAMETER")
        + _object("ParameterProxy", "PARAMETER", {}, preset="PRESET")
        + _object("ParameterPreset", "PRESET", {"name": "Anger"}),
    )
    master = f'class="EventMixerMaster" id="{{{guid("event master", 0)}}}">\n'
    assert master in event.read_text()
    automated = '\t\t<relationship name="automators">\n\t\t\t<destination>{AUTO}</destination>\n\t\t</relationship>\n'
    event.write_text(event.read_text().replace(master, master + automated))
    (one,) = read_fmod(path).played
    assert [(found.on, found.what) for found in one.depends] == [("state", 'parameter "Anger"')]


def test_a_snapshot_and_a_vca(tmp_path):
    path, _ = one_event(tmp_path)
    bus = guid("bus", 0)
    snapshot = _objects(
        _object("Snapshot", "SNAP", {"name": "Underwater"}),
        _object("SnapshotProperty", "MOVED", {"propertyName": "volume", "value": -12}, automatableObject=bus),
    )
    (tmp_path / "Metadata" / "Snapshot.xml").write_text(snapshot)
    (tmp_path / "Metadata" / "VCA.xml").write_text(
        _objects(_object("MixerVCA", "VCA", {"name": "SFX", "volume": -4}, strips=bus))
    )
    (one,) = read_fmod(path).played
    assert one.gain_db == -4.0
    assert one.parts[0].object_path == "vca:/SFX"
    assert [found.what for found in one.depends] == ['snapshot "Underwater"']


def test_an_event_within_another_takes_that_events_way(tmp_path):
    path, _ = one_event(tmp_path)
    outer = _objects(
        _object("Event", "OUTER", {"name": "outer"}, mixer="OM", mixerInput="OI", banks=guid("bank")),
        _object("EventMixer", "OM", {}, masterBus="OMM"),
        _object("EventMixerMaster", "OMM", {"volume": 2}),
        _object("MixerInput", "OI", {}, output=guid("bus", 0)),
        _object("GroupTrack", "OT", {}, modules="ES", mixerGroup="OG"),
        _object("EventMixerGroup", "OG", {"name": "t"}, output="OMM"),
        _object("EventSound", "ES", {"volume": 1}, event=guid("event", 0)),
    )
    (tmp_path / "Metadata" / "Event" / "{OUTER}.xml").write_text(outer)
    project = read_fmod(path)
    assert sorted((one.events, one.gain_db) for one in project.played) == [
        (("event:/event_0",), 0.0),
        (("event:/outer",), 3.0),
    ]


def test_an_event_in_no_bank_is_not_heard(tmp_path):
    path, event = one_event(tmp_path)
    event.write_text(event.read_text().replace('name="banks"', 'name="nothing"'))
    (one,) = read_fmod(path).played
    assert (one.is_used, one.events) == (False, ())


def test_what_plays_itself_ends(tmp_path):
    path, _ = one_event(
        tmp_path,
        _object("EventSound", "SELF", {}, event=guid("event", 0))
        + _object("GroupTrack", "ST", {}, modules="SELF", mixerGroup=guid("group", 0)),
    )
    assert read_fmod(path).played


def test_a_file_that_is_no_metadata_is_named(tmp_path):
    path, _ = one_event(tmp_path)
    (tmp_path / "Metadata" / "Odd.xml").write_text("<html/>")
    project = read_fmod(path)
    assert [(one.file, one.message) for one in project.unread] == [
        ("Metadata/Odd.xml", "is a <html> document; wanted <objects>")
    ]
    assert len(project.played) == 1
