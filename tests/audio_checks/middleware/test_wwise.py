"""Wwise: what stands in work units beside gains."""

import pytest

from audio_checks.middleware.wwise import read_wwise

SOUND, BUS, MASTER, EVENT = "{A1}", "{B1}", "{1514A4D8-1DA6-412A-A17E-75CA0C2149F3}", "{E1}"
RTPC = (
    '<RTPCList><RTPC Name="" ID="{R}"><ReferenceList><Reference Name="ControlInput"><ObjectRef Name="RPM" ID="{G}"/>'
    "</Reference></ReferenceList></RTPC></RTPCList>"
)


def unit(category, body, more=""):
    return (
        '<?xml version="1.0" encoding="utf-8"?><WwiseDocument '
        f'Type="WorkUnit" ID="{{U{category}}}" SchemaVersion="110">'
        f'<{category}><WorkUnit Name="Default Work Unit" ID="{{U{category}}}" PersistMode="Standalone" {more}>'
        f"<ChildrenList>{body}</ChildrenList></WorkUnit></{category}></WwiseDocument>"
    )


def source(id_="{S1}", file="steps\\deck.WAV", language="SFX", inner=""):
    return (
        f'<AudioFileSource Name="deck" ID="{id_}">{inner}<Language>{language}'
        f"</Language><AudioFile>{file}</AudioFile></AudioFileSource>"
    )


@pytest.fixture
def wwise(put):
    """Read a project of one sound; return how it is played."""

    def read(properties="", sources=None, after="", bus="", references="", events=None, more_files=None):
        put("Game.wproj", '<WwiseDocument Type="Project" WwiseVersion="v2023.1.4"/>')
        route = f'<Reference Name="OutputBus"><ObjectRef Name="Steps" ID="{BUS}"/></Reference>{references}'
        sound = (
            f'<Sound Name="deck" ID="{SOUND}"><PropertyList>{properties}'
            f"</PropertyList><ReferenceList>{route}</ReferenceList>"
            f"<ChildrenList>{source() if sources is None else sources}</ChildrenList>{after}</Sound>"
        )
        put("Actor-Mixer Hierarchy/Foley.wwu", unit("AudioObjects", sound))
        buses = (
            f'<Bus Name="Main" ID="{MASTER}"><ChildrenList><Bus '
            f'Name="Steps" ID="{BUS}">{bus}</Bus></ChildrenList></Bus>'
        )
        put("Master-Mixer Hierarchy/Default Work Unit.wwu", unit("Busses", buses))
        action = events or (
            f'<Event Name="Play_deck" ID="{EVENT}"><ChildrenList><Action Name="" ID="{{C}}"><ReferenceList>'
            f'<Reference Name="Target"><ObjectRef Name="deck" ID="{SOUND}"/>'
            "</Reference></ReferenceList></Action></ChildrenList></Event>"
        )
        root = put("Events/Default Work Unit.wwu", unit("Events", action))
        for path, text in (more_files or {}).items():
            put(path, text)
        return read_wwise(root / "Game.wproj")

    return read


def only(project):
    assert project.unread == ()
    (one,) = project.played
    return one


def test_a_property_in_both_forms(wwise):
    assert only(wwise('<Property Name="Volume" Type="Real64" Value="-2.5"/>')).gain_db == -2.5
    listed = '<Property Name="Volume" Type="Real64"><ValueList><Value>4</Value></ValueList></Property>'
    assert only(wwise(listed)).gain_db == 4.0


def test_of_platforms_the_shared_value_counts_and_the_others_are_reported(wwise):
    text = (
        '<Property Name="Volume" Type="Real64"><ValueList><Value '
        'Platform="PS5">1</Value><Value>3</Value></ValueList></Property>'
    )
    one = only(wwise(text))
    assert one.gain_db == 3.0
    assert [found.what for found in one.depends] == ["the platform"]


def test_a_game_parameter_a_state_and_a_random_range(wwise):
    state = (
        '<StateInfo><CustomStateList><CustomState><StateRef Name="Cave" '
        'ID="{T}"/><CustomState Name="" ID="{V}"><PropertyList>'
        '<Property Name="BusVolume" Type="Real64" Value="-9"/></PropertyList>'
        "</CustomState></CustomState></CustomStateList></StateInfo>"
    )
    modifier = (
        '<ModifierList><ModifierInfo><Modifier Name="" ID="{M}">'
        '<PropertyList><Property Name="Enabled" Type="bool" Value="True"/>'
        '<Property Name="Min" Type="Real64" Value="-2"/><Property '
        'Name="Max" Type="Real64" Value="1"/></PropertyList></Modifier>'
        "</ModifierInfo></ModifierList>"
    )
    one = only(wwise(f'<Property Name="Volume" Type="Real64">{RTPC}{modifier}</Property>', bus=state))
    assert one.gain_db == 0.0
    assert [(found.on, found.what) for found in one.depends] == [
        ("state", 'game parameter "RPM"'),
        ("random", "random from -2 to 1 dB"),
        ("state", 'state "Cave", -9 dB'),
    ]
    assert one.depends[2].object_path == r"\Master-Mixer Hierarchy\Default Work Unit\Main\Steps"


def test_loudness_normalization_effects_and_attenuation_are_reported(wwise):
    references = (
        '<Reference Name="Effect0" PluginName="Gain"><ObjectRef Name="Warm" ID="{F}"/></Reference>'
        '<Reference Name="Attenuation"><ObjectRef Name="near" ID="{N}"/></Reference>'
    )
    one = only(wwise('<Property Name="EnableLoudnessNormalization" Type="bool" Value="True"/>', references=references))
    assert {found.on for found in one.depends} == {"loudness", "effect", "distance"}


def test_the_active_source_of_each_language_is_played(wwise):
    sources = source("{S1}") + source("{S2}", "other.wav") + source("{S3}", "hi.wav", "English(US)")
    active = '<ActiveSourceList><ActiveSource Name="deck" ID="{S2}" Platform="Linked"/></ActiveSourceList>'
    project = wwise(sources=sources, after=active)
    assert [one.file for one in project.played] == ["Originals/SFX/other.wav", "Originals/Voices/English(US)/hi.wav"]


def test_a_file_is_found_whatever_the_case_of_its_name(wwise):
    project = wwise(more_files={"Originals/SFX/Steps/Deck.wav": "x"})
    assert only(project).file == "Originals/SFX/Steps/Deck.wav"


def test_loops_streams_and_what_is_in_no_event(wwise):
    one = only(wwise('<Property Name="IsLoopingEnabled" Type="bool" Value="True"/>', events="<Folder/>"))
    assert (one.is_looped, one.is_streamed, one.is_used, one.events) == (True, False, False, ())


def test_only_an_action_that_plays_uses_a_sound(wwise):
    stop = (
        f'<Event Name="Stop_deck" ID="{EVENT}"><ChildrenList><Action '
        f'Name="" ID="{{C}}"><PropertyList><Property Name="ActionType"'
        ' Type="int16" Value="2"/></PropertyList><ReferenceList>'
        f'<Reference Name="Target"><ObjectRef Name="deck" ID="{SOUND}"/>'
        "</Reference></ReferenceList></Action></ChildrenList></Event>"
    )
    assert only(wwise(events=stop)).is_used is False


def test_an_event_may_play_another(wwise):
    def event(name, id_, target):
        return (
            f'<Event Name="{name}" ID="{id_}"><ChildrenList><Action Name="" ID="{{C{name}}}"><ReferenceList><Reference '
            f'Name="Target"><ObjectRef Name="x" ID="{target}"/>'
            "</Reference></ReferenceList></Action></ChildrenList></Event>"
        )

    one = only(wwise(events=event("inner", "{I}", SOUND) + event("outer", "{O}", "{I}") + event("self", "{Z}", "{Z}")))
    assert one.events == ("inner", "outer")


def test_an_object_below_another_routes_through_its_parent_unless_it_overrides(put):
    inner = (
        '<Sound Name="deck" ID="{A1}"><PropertyList>%s</PropertyList>'
        '<ReferenceList><Reference Name="OutputBus"><ObjectRef Name="Loud"'
        f' ID="{{L}}"/></Reference></ReferenceList><ChildrenList>{source()}</ChildrenList></Sound>'
    )
    mixer = (
        '<ActorMixer Name="all" ID="{X}"><ReferenceList><Reference Name="OutputBus"><ObjectRef Name="Main" ID="'
        f'{MASTER}"/></Reference></ReferenceList><ChildrenList>{inner}</ChildrenList></ActorMixer>'
    )
    loud = (
        '<Bus Name="Loud" ID="{L}"><PropertyList><Property '
        'Name="BusVolume" Type="Real64" Value="7"/></PropertyList></Bus>'
    )
    put(
        "Busses/Default Work Unit.wwu",
        unit("Busses", f'<Bus Name="Main" ID="{MASTER}"><ChildrenList>{loud}</ChildrenList></Bus>'),
    )
    for override, gain_db in (("", 0.0), ('<Property Name="OverrideOutput" Type="bool" Value="True"/>', 7.0)):
        put("Game.wproj", '<WwiseDocument Type="Project" WwiseVersion="v2025.1.3"/>')
        root = put("Containers/Default Work Unit.wwu", unit("Containers", mixer % override))
        assert only(read_wwise(root / "Game.wproj")).gain_db == gain_db


def test_a_conversion_that_resamples_is_named(wwise):
    conversion = unit(
        "Conversions",
        '<Conversion Name="Small" ID="{K}"><PropertyList><Property '
        'Name="SampleRate" Type="int32"><ValueList><Value>24000</Value>'
        '</ValueList></Property></PropertyList><ConversionPluginInfoList><ConversionPluginInfo Platform="Windows">'
        '<ConversionPlugin PluginName="ADPCM"/></ConversionPluginInfo></ConversionPluginInfoList></Conversion>',
    )
    reference = '<Reference Name="Conversion"><ObjectRef Name="Small" ID="{K}"/></Reference>'
    one = only(wwise(references=reference, more_files={"Conversion Settings/Default Work Unit.wwu": conversion}))
    assert [found.harm for found in one.conversions] == ["resampled to 24,000 Hz", "4 bits a sample undo the dither"]


def test_what_cannot_be_read_is_named_with_its_line_and_the_rest_is_read(wwise):
    project = wwise(
        more_files={
            "Actor-Mixer Hierarchy/Broken.wwu": (
                '<WwiseDocument>\n<AudioObjects>\n<Sound Name="x" ID="{Q}">\n</AudioObjects>'
            ),
            "Actor-Mixer Hierarchy/Entities.wwu": (
                '<!DOCTYPE x [<!ENTITY a "b">]>\n<WwiseDocument><AudioObjects/></WwiseDocument>'
            ),
        }
    )
    assert [one.file for one in project.played] == ["Originals/SFX/steps/deck.WAV"]
    assert [(one.file.rpartition("/")[2], one.line) for one in project.unread] == [
        ("Broken.wwu", 4),
        ("Entities.wwu", 0),
    ]
    assert "not XML" in project.unread[0].message
    assert "document type" in project.unread[1].message


def test_objects_too_deep_in_one_another_are_refused(wwise):
    deep = (
        "".join(f'<ActorMixer Name="m" ID="{{D{one}}}"><ChildrenList>' for one in range(200))
        + "</ChildrenList></ActorMixer>" * 200
    )
    project = wwise(more_files={"Actor-Mixer Hierarchy/Deep.wwu": unit("AudioObjects", deep)})
    assert ["deep" in one.message for one in project.unread] == [True]
    assert len(project.played) == 1


def test_units_that_own_one_another_end(put):
    put("Game.wproj", '<WwiseDocument Type="Project"/>')
    for one, other in (("A", "B"), ("B", "A")):
        root = put(
            f"Actor-Mixer Hierarchy/{one}.wwu",
            f'<WwiseDocument><AudioObjects><WorkUnit Name="{one}" ID="{{{one}}}" '
            f'OwnerID="{{{other}}}" PersistMode="Nested"><ChildrenList>'
            f'<Sound Name="s" ID="{{S{one}}}"><ChildrenList>{source()}</ChildrenList>'
            "</Sound></ChildrenList></WorkUnit></AudioObjects></WwiseDocument>",
        )
    assert len(read_wwise(root / "Game.wproj").played) == 2
