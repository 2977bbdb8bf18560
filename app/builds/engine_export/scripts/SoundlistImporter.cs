using System;
using System.IO;
using System.Linq;
using UnityEditor;
using UnityEngine;

/// <summary>
/// Imports the sounds of a Soundlist pack. Settings are applied when a sound has none yet; those that a team chose stay.
/// Tools > Soundlist > Create event prefabs makes a prefab for each event and leaves those that are up to date.
/// </summary>
public class SoundlistImporter : AssetPostprocessor
{
    private const string Prefabs = "Assets/Soundlist/Events";
    private const string DocumentPath = "Assets/Soundlist/Editor/soundlist-handoff.json";
    private const int Format = 1;

    private static Sound[] sounds;
    private static DateTime soundsWritten;

    [Serializable]
    private class Document
    {
        public int format = 0;
        public Sound[] sounds = new Sound[0];
    }

    [Serializable]
    private class Sound
    {
        public string cue = "";
        public string load = "";
        public string compression = "";
        public bool loop = false;
        public string[] event_path = new string[0];
        public SoundFile[] files = new SoundFile[0];

        public string PrefabPath
        {
            get { return Prefabs + "/" + string.Join("/", event_path) + ".prefab"; }
        }
    }

    [Serializable]
    private class SoundFile
    {
        public string path = "";
    }

    private void OnPreprocessAudio()
    {
        if (!assetImporter.importSettingsMissing)
        {
            return;
        }
        Sound sound = Sounds().FirstOrDefault(one => one.files.Any(file => InProject(file.path) == assetPath));
        if (sound == null)
        {
            return;
        }
        AudioImporter importer = (AudioImporter)assetImporter;
        importer.forceToMono = false;
        importer.loadInBackground = sound.load == "streaming";
        AudioImporterSampleSettings settings = importer.defaultSampleSettings;
        settings.sampleRateSetting = AudioSampleRateSetting.PreserveSampleRate;
        settings.loadType = LoadType(sound.load);
        settings.compressionFormat = Compression(sound.compression);
        importer.defaultSampleSettings = settings;
    }

    private static AudioClipLoadType LoadType(string load)
    {
        switch (load)
        {
            case "streaming":
                return AudioClipLoadType.Streaming;
            case "compressed":
                return AudioClipLoadType.CompressedInMemory;
            default:
                return AudioClipLoadType.DecompressOnLoad;
        }
    }

    private static AudioCompressionFormat Compression(string compression)
    {
        switch (compression)
        {
            case "vorbis":
                return AudioCompressionFormat.Vorbis;
            case "adpcm":
                return AudioCompressionFormat.ADPCM;
            default:
                return AudioCompressionFormat.PCM;
        }
    }

    [MenuItem("Tools/Soundlist/Create event prefabs")]
    private static void CreatePrefabs()
    {
        int made = 0, changed = 0, same = 0;
        foreach (Sound sound in Sounds())
        {
            AudioClip[] clips = sound.files.Select(file => ClipAt(file.path)).Where(clip => clip != null).ToArray();
            if (clips.Length < sound.files.Length)
            {
                Debug.LogWarning("Soundlist: " + sound.cue + " lacks files, so its prefab was left as it is.");
                continue;
            }
            GameObject known = AssetDatabase.LoadAssetAtPath<GameObject>(sound.PrefabPath);
            if (known == null)
            {
                CreatePrefab(sound, clips);
                made++;
            }
            else if (Clips(known).SequenceEqual(clips))
            {
                same++;
            }
            else
            {
                GameObject content = PrefabUtility.LoadPrefabContents(sound.PrefabPath);
                SetClips(content, clips);
                PrefabUtility.SaveAsPrefabAsset(content, sound.PrefabPath);
                PrefabUtility.UnloadPrefabContents(content);
                changed++;
            }
        }
        Debug.Log("Soundlist: " + made + " prefabs made, " + changed + " changed, " + same + " up to date.");
    }

    private static void CreatePrefab(Sound sound, AudioClip[] clips)
    {
        Directory.CreateDirectory(Path.GetDirectoryName(sound.PrefabPath));
        GameObject content = new GameObject(Path.GetFileNameWithoutExtension(sound.PrefabPath));
        AudioSource source = content.AddComponent<AudioSource>();
        source.playOnAwake = false;
        source.loop = sound.loop;
        SetClips(content, clips);
        PrefabUtility.SaveAsPrefabAsset(content, sound.PrefabPath);
        UnityEngine.Object.DestroyImmediate(content);
    }

    private static AudioClip[] Clips(GameObject content)
    {
        SoundlistSet set = content.GetComponent<SoundlistSet>();
        if (set != null)
        {
            return set.clips;
        }
        AudioSource source = content.GetComponent<AudioSource>();
        return source == null || source.clip == null ? new AudioClip[0] : new[] { source.clip };
    }

    private static void SetClips(GameObject content, AudioClip[] clips)
    {
        SoundlistSet set = content.GetComponent<SoundlistSet>();
        AudioSource source = content.GetComponent<AudioSource>();
        if (source == null)
        {
            source = content.AddComponent<AudioSource>();
        }
        if (clips.Length > 1 && set == null)
        {
            set = content.AddComponent<SoundlistSet>();
        }
        if (set != null)
        {
            set.clips = clips;
        }
        source.clip = clips[0];
    }

    private static string InProject(string path)
    {
        return path.StartsWith("Assets/", StringComparison.Ordinal) ? path : "Assets/" + path;
    }

    private static AudioClip ClipAt(string path)
    {
        return AssetDatabase.LoadAssetAtPath<AudioClip>(InProject(path));
    }

    private static Sound[] Sounds()
    {
        DateTime written = File.GetLastWriteTimeUtc(DocumentPath);
        if (sounds == null || written != soundsWritten)
        {
            sounds = new Sound[0];
            soundsWritten = written;
            if (File.Exists(DocumentPath))
            {
                Document document = JsonUtility.FromJson<Document>(File.ReadAllText(DocumentPath));
                sounds = document.format == Format ? document.sounds : new Sound[0];
            }
        }
        return sounds;
    }
}
