using UnityEngine;

/// <summary>Plays one clip of a set at random, never the same twice in a row. Written by Soundlist.</summary>
[RequireComponent(typeof(AudioSource))]
public class SoundlistSet : MonoBehaviour
{
    public AudioClip[] clips = new AudioClip[0];

    private int last = -1;

    /// <summary>Plays the next clip through the audio source of this object.</summary>
    public void Play()
    {
        if (clips.Length == 0)
        {
            return;
        }
        int next = Random.Range(0, clips.Length);
        if (next == last && clips.Length > 1)
        {
            next = (next + 1) % clips.Length;
        }
        last = next;
        AudioSource source = GetComponent<AudioSource>();
        source.clip = clips[next];
        source.Play();
    }
}
