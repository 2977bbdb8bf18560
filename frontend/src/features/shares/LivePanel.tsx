import { Button } from '@/ui/Button'
import { Card, CardHead } from '@/ui/Card'
import { Icon } from '@/ui/Icon'
import { Person } from '@/ui/Person'
import { ErrorBanner } from '@/ui/ErrorBanner'
import { Row, Rows } from '@/ui/Rows'

import type { Live } from './api'
import type { LiveHand } from './useLive'

interface LivePanelProps {
  hand: LiveHand
  meId: string | undefined
  /** The session was started or joined: the focus goes to where it is played. */
  onJoin: () => void
}

/** Who hears the same, who has control, and how they change hands. */
export function LivePanel({ hand, meId, onJoin }: LivePanelProps) {
  const { live, isIn, problem } = hand
  const present = live?.present ?? []
  return (
    <Card aria-labelledby="session">
      <CardHead
        id="session"
        title="Session"
        count={present.length}
        end={
          isIn ? (
            <Button icon="cross" onClick={hand.leave}>
              Leave
            </Button>
          ) : (
            <Button
              icon="people"
              onClick={() => {
                hand.join()
                onJoin()
              }}
            >
              {present.length > 0 ? 'Join session' : 'Start session'}
            </Button>
          )
        }
      />
      <div className="grid gap-3 p-3-inset-4">
        {!isIn && (
          <p className="mid">
            Everyone of the team who joins hears the same playhead. One person has control; nobody needs to share a
            screen.
          </p>
        )}
        {problem !== '' && <ErrorBanner detail={problem} />}
        {isIn && live?.is_elsewhere && <Elsewhere live={live} hand={hand} meId={meId} />}
        {isIn && !live?.is_elsewhere && (
          <p role="status" className="row wrap">
            {live?.holder ? (
              <>
                <Icon name="headphones" />
                {live.is_holder ? 'You have control: all hear what you play.' : `${live.holder.name} has control.`}
              </>
            ) : (
              'The keys are free.'
            )}
            {live && !live.holder && (
              <Button variant="primary" onClick={hand.take}>
                Take control
              </Button>
            )}
            {live?.is_holder && <Button onClick={hand.drop}>Release control</Button>}
          </p>
        )}
      </div>
      {present.length > 0 && (
        <Rows aria-label="In the session">
          {present.map(({ id, name, picture }) => (
            <Row key={id} dense>
              <Person
                name={id === meId ? `${name} (you)` : name}
                picture={picture}
                role={live?.holder?.id === id ? 'has control' : undefined}
              />
              {live?.is_holder && id !== meId && (
                <span className="end">
                  <Button onClick={() => hand.give(id)}>
                    Hand over <span className="visually-hidden">control to {name}</span>
                  </Button>
                </span>
              )}
            </Row>
          ))}
        </Rows>
      )}
    </Card>
  )
}

/** Another page of the same person plays the session; this one is silent until it takes over. */
function Elsewhere({ live, hand, meId }: { live: Live; hand: LiveHand; meId: string | undefined }) {
  const mayTake = live.holder === null || live.holder.id === meId
  return (
    <p role="status" className="row wrap">
      <Icon name="headphones" />
      {live.holder?.id === meId
        ? 'You have control in another tab, which plays the session. This tab is silent.'
        : 'You hear the session in another tab. This tab is silent.'}
      {mayTake ? (
        <Button variant="primary" onClick={hand.take}>
          Take control here
        </Button>
      ) : (
        <Button variant="primary" onClick={hand.takeOver}>
          Listen here
        </Button>
      )}
    </p>
  )
}
